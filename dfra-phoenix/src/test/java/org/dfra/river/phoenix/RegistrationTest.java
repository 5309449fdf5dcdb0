package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.tuple;

import java.io.Serializable;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationSystem;
import java.rmi.activation.UnknownGroupException;
import java.rmi.activation.UnknownObjectException;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** ActivationSystem and ActivationAdmin: what is registered, and what is refused. */
class RegistrationTest {

  @TempDir Path temp;
  private InVmPhoenix phoenix;
  private ActivationSystem system;

  @BeforeEach
  void start() throws Exception {
    phoenix = new InVmPhoenix(temp).start();
    system = phoenix.system();
  }

  @AfterEach
  void end() {
    phoenix.close();
  }

  @Test
  void groupsReceivePhoenixsNewAddress() throws Exception {
    ActivationGroupID stays = system.registerGroup(named("first"));
    ActivationGroupID group = system.registerGroup(named("gps"));
    ActivationDesc desc =
        new ActivationDesc(group, "a.B", null, new MarshalledObject<>("x"), false);
    ActivationID object = system.registerObject(desc);
    List<GroupStatus> before = phoenix.admin().groupStatus();

    for (int move = 1; move <= 2; move++) {
      phoenix.close();
      phoenix.moves().start();
      system = phoenix.system();
      Map<ActivationGroupID, ActivationGroupDesc> groups = phoenix.admin().getActivationGroups();

      assertThat(phoenix.admin().groupStatus())
          .extracting(GroupStatus::name, GroupStatus::incarnation, GroupStatus::objects)
          .as("after move %d", move)
          .containsExactlyElementsOf(
              before.stream().map(g -> tuple(g.name(), g.incarnation(), g.objects())).toList());
      assertThat(groups).hasSize(2).doesNotContainKeys(stays, group).containsValue(named("gps"));
      ActivationGroupID moved = List.copyOf(groups.keySet()).get(1);
      assertThat(moved.getSystem()).isEqualTo(List.copyOf(groups.keySet()).get(0).getSystem());
      assertThat(moved.getSystem().getActivationGroupDesc(moved))
          .as("asked through the identity's own system")
          .isEqualTo(named("gps"));
      assertThat(phoenix.admin().getActivatableObjects(moved).values())
          .containsExactly(new ActivationDesc(moved, "a.B", null, desc.getData(), false));
      assertThatExceptionOfType(UnknownGroupException.class)
          .isThrownBy(() -> system.getActivationGroupDesc(group));
      assertThat(system.getActivationDesc(object).getGroupID())
          .as("an object keeps its identity")
          .isEqualTo(moved);
    }
  }

  @Test
  void groupsKeepTheirIdentityWherePhoenixKeepsItsAddress() throws Exception {
    ActivationGroupID group = system.registerGroup(named("gps"));
    phoenix.close();
    phoenix.start();
    assertThat(phoenix.admin().getActivationGroups()).isEqualTo(Map.of(group, named("gps")));
  }

  @Test
  void returnsTheDescriptorsThatWereRegistered() throws Exception {
    ActivationGroupDesc groupDesc = named("gps");
    ActivationGroupID group = system.registerGroup(groupDesc);
    ActivationDesc desc = new ActivationDesc(group, "a.B", null, new MarshalledObject<>("x"), true);
    ActivationID object = system.registerObject(desc);

    assertThat(system.getActivationGroupDesc(group)).isEqualTo(groupDesc);
    assertThat(system.getActivationDesc(object)).isEqualTo(desc);
    assertThat(phoenix.admin().getActivationGroups()).isEqualTo(Map.of(group, groupDesc));
    assertThat(phoenix.admin().getActivatableObjects(group)).isEqualTo(Map.of(object, desc));
    assertThat(phoenix.status(0).name()).isEqualTo("1-gps");
    assertThat(phoenix.status(0).objects()).isEqualTo(1);
    assertThat(phoenix.status(0).state()).isEqualTo(GroupStatus.State.IDLE);
  }

  @Test
  void newDescriptorsReplaceAndReturnTheOldOnes() throws Exception {
    ActivationGroupDesc first = named("first");
    ActivationGroupID group = system.registerGroup(first);
    ActivationDesc before = new ActivationDesc(group, "a.Before", null, null);
    ActivationID object = system.registerObject(before);
    ActivationDesc after = new ActivationDesc(group, "a.After", null, null, true);

    assertThat(system.setActivationDesc(object, after)).isEqualTo(before);
    assertThat(system.getActivationDesc(object)).isEqualTo(after);
    assertThat(system.setActivationGroupDesc(group, named("second"))).isEqualTo(first);
    assertThat(system.getActivationGroupDesc(group)).isEqualTo(named("second"));
  }

  @Test
  void objectStaysInItsGroup() throws Exception {
    ActivationGroupID group = system.registerGroup(named("one"));
    ActivationGroupID other = system.registerGroup(named("other"));
    ActivationID object = system.registerObject(new ActivationDesc(group, "a.B", null, null));
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(
            () -> system.setActivationDesc(object, new ActivationDesc(other, "a.B", null, null)))
        .withMessage("the new descriptor is of another group; an object stays in 1-one");
    assertThat(system.getActivationDesc(object).getGroupID()).isEqualTo(group);
  }

  @Test
  void unregisteredObjectIsUnknown() throws Exception {
    ActivationGroupID group = phoenix.group();
    ActivationID object = phoenix.object(group, false);
    system.unregisterObject(object);
    assertObjectUnknown(object, group);
    assertThat(phoenix.admin().getActivatableObjects(group)).isEmpty();
  }

  @Test
  void idOfAForeignClassIsAnUnknownObject() throws Exception {
    assertObjectUnknown(new ForeignId(), phoenix.group());
  }

  private void assertObjectUnknown(ActivationID object, ActivationGroupID group) {
    ActivationDesc desc = new ActivationDesc(group, "a.B", null, null);
    assertAllThrow(
        UnknownObjectException.class,
        () -> system.unregisterObject(object),
        () -> system.getActivationDesc(object),
        () -> system.setActivationDesc(object, desc));
    if (!(object instanceof ForeignId)) {
      assertAllThrow(UnknownObjectException.class, () -> object.activate(false));
    }
  }

  @Test
  void unregisteringAGroupDropsItsObjects() throws Exception {
    ActivationGroupID group = phoenix.group();
    ActivationID object = phoenix.object(group, false);
    ActivationGroupID other = phoenix.group();
    ActivationID stays = phoenix.object(other, false);
    system.unregisterGroup(group);

    assertObjectUnknown(object, group);
    assertAllThrow(
        UnknownGroupException.class,
        () -> system.unregisterGroup(group),
        () -> system.getActivationGroupDesc(group),
        () -> system.setActivationGroupDesc(group, named("x")),
        () -> system.registerObject(new ActivationDesc(group, "a.B", null, null)),
        () -> system.activeGroup(group, new FakeGroup().proxy, 1),
        () -> phoenix.admin().getActivatableObjects(group));
    assertThat(phoenix.admin().getActivatableObjects(other)).containsOnlyKeys(stays);
  }

  @Test
  void customGroupsAreRefusedUnlessPermitted() throws Exception {
    List<ActivationGroupDesc> custom =
        List.of(
            new ActivationGroupDesc("a.Group", null, null, null, null),
            new ActivationGroupDesc(null, "file:/x", null, null, null),
            new ActivationGroupDesc(null, null, new MarshalledObject<>("x"), null, null));
    ActivationGroupID group = phoenix.group();
    for (ActivationGroupDesc desc : custom) {
      assertAllThrow(
          ActivationException.class,
          () -> system.registerGroup(desc),
          () -> system.setActivationGroupDesc(group, desc));
    }
    assertThat(phoenix.admin().getActivationGroups()).hasSize(1);
    phoenix.close();
    phoenix.start("customGroups = true;");
    for (ActivationGroupDesc desc : custom) {
      assertThat(system.getActivationGroupDesc(system.registerGroup(desc))).isEqualTo(desc);
    }
  }

  @Test
  void everythingIsThereAfterARestart() throws Exception {
    ActivationGroupID group = system.registerGroup(named("gps"));
    ActivationID object = phoenix.object(group, true);
    Map<ActivationGroupID, ActivationGroupDesc> groups = phoenix.admin().getActivationGroups();
    ActivationDesc desc = system.getActivationDesc(object);
    phoenix.close();
    phoenix.start("restartLimit = 2;");

    assertThat(phoenix.admin().getActivationGroups()).isEqualTo(groups);
    assertThat(system.getActivationDesc(object)).isEqualTo(desc);
    assertThat(phoenix.admin().getActivatableObjects(group)).containsOnlyKeys(object);
    assertThat(system.registerGroup(named("next"))).isNotEqualTo(group);
    assertThat(phoenix.status(1).name()).as("numbers go on").isEqualTo("2-next");
  }

  @Test
  void secondPhoenixIsRefusedWithTheWayOut() throws Exception {
    try (InVmPhoenix second = new InVmPhoenix(temp)) {
      assertThatExceptionOfType(java.io.IOException.class)
          .isThrownBy(second::start)
          .withMessageContaining("still owns this journal");
    }
    system.registerGroup(named("still works"));
  }

  private static ActivationGroupDesc named(String name) {
    Properties properties = new Properties();
    properties.setProperty(Phoenix.GROUP_NAME, name);
    return new ActivationGroupDesc(properties, null);
  }

  private static void assertAllThrow(Class<? extends Exception> type, ThrowingCallable... calls) {
    for (int i = 0; i < calls.length; i++) {
      assertThatExceptionOfType(type).as("call %s", i).isThrownBy(calls[i]);
    }
  }

  /** Of some other activation system; it travels, and phoenix has its class. */
  private static final class ForeignId extends ActivationID {
    private static final long serialVersionUID = 1L;

    ForeignId() {
      super(null);
    }

    private Object writeReplace() {
      return new Form();
    }

    private record Form() implements Serializable {
      private Object readResolve() {
        return new ForeignId();
      }
    }
  }
}
