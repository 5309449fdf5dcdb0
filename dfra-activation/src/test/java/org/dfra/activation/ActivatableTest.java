package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.Serializable;
import java.rmi.ConnectException;
import java.rmi.MarshalledObject;
import java.rmi.NoSuchObjectException;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.rmi.ServerException;
import java.rmi.activation.Activatable;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroup;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.rmi.activation.UnknownObjectException;
import java.rmi.server.RemoteObject;
import java.rmi.server.UnicastRemoteObject;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Activatable objects over JRMP: registered, called, asleep, and called again. */
class ActivatableTest {

  /** What the tests call; not public, as reggie's own interface is not. */
  interface Lamp extends Remote {
    String name() throws RemoteException;

    void broken() throws RemoteException;
  }

  static class LampImpl extends Activatable implements Lamp {
    private static final LoopbackSockets SOCKETS = new LoopbackSockets();
    private final String name;

    LampImpl(ActivationID id, String name) throws RemoteException {
      super(id, 0, SOCKETS, SOCKETS);
      this.name = name;
    }

    LampImpl(String name) throws Exception {
      super(null, new MarshalledObject<>("on"), true, 0, SOCKETS, SOCKETS);
      this.name = name;
    }

    ActivationID id() {
      return getID();
    }

    @Override
    public String name() {
      return name;
    }

    @Override
    public void broken() throws RemoteException {
      throw new NoSuchObjectException("of another server, from inside the call");
    }
  }

  /** Has no superclass of RMI's. */
  record Bulb(String name) implements Lamp, Serializable {
    @Override
    public void broken() {}
  }

  private final LoopbackSockets sockets = new LoopbackSockets();
  private final TestDaemon daemon = new TestDaemon();
  private final ActivationGroupID group = new ActivationGroupID(daemon);
  private final List<Remote> exported = new ArrayList<>();

  @BeforeEach
  void groupInThisJvm() throws Exception {
    FreshJvm.pretend();
    ActivationGroup.createGroup(
        group, new ActivationGroupDesc(PlainGroup.class.getName(), null, null, null, null), 1);
    exported.add(PlainGroup.last);
    daemon.calls.clear();
  }

  @AfterEach
  void unexport() {
    for (Remote object : exported) {
      try {
        UnicastRemoteObject.unexportObject(object, true);
      } catch (NoSuchObjectException e) {
        // The test ended its export.
      }
    }
    FreshJvm.pretend();
  }

  private <T extends Remote> T keep(T object) {
    exported.add(object);
    return object;
  }

  private ActivationID registered() {
    return daemon.registerObject(new ActivationDesc(group, LampImpl.class.getName(), null, null));
  }

  @Test
  void registeredObjectIsActivatedByItsFirstCallOnly() throws Exception {
    Lamp lamp =
        (Lamp)
            Activatable.register(new ActivationDesc(group, LampImpl.class.getName(), null, null));
    ActivationID id = daemon.objects.keySet().iterator().next();
    daemon.live = new MarshalledObject<>(keep(new LampImpl(id, "left")));

    assertThat(daemon.calls).isEmpty();
    assertThat(lamp.name()).isEqualTo("left");
    assertThat(lamp.name()).isEqualTo("left");
    assertThat(daemon.calls).containsExactly("activate false");
  }

  @Test
  void exportedObjectComesBackAfterItsDeath() throws Exception {
    ActivationID id = registered();
    Bulb first = keep(new Bulb("first"));
    Lamp lamp = (Lamp) Activatable.exportObject(first, id, 0, sockets, sockets);
    assertThat(lamp.name()).isEqualTo("first");

    assertThat(Activatable.unexportObject(first, true)).isTrue();
    Bulb second = keep(new Bulb("second"));
    daemon.live =
        new MarshalledObject<>(UnicastRemoteObject.exportObject(second, 0, sockets, sockets));

    assertThat(lamp.name()).isEqualTo("second");
    assertThat(daemon.calls).containsExactly("activate false");
  }

  @Test
  void deadProxyFromTheDaemonIsRefreshedByForceAndThenTheCallFails() throws Exception {
    ActivationID id = registered();
    Bulb bulb = keep(new Bulb("first"));
    Lamp lamp = (Lamp) Activatable.exportObject(bulb, id, 0, sockets, sockets);
    daemon.live = new MarshalledObject<>(RemoteObject.toStub(bulb));
    Activatable.unexportObject(bulb, true);

    assertThatExceptionOfType(NoSuchObjectException.class).isThrownBy(lamp::name);
    assertThat(daemon.calls).containsExactly("activate false", "activate true");
  }

  @Test
  void callThatMayHaveRunIsNotRepeated() throws Exception {
    ActivationID id = registered();
    // JRMP wraps an exception from inside the call, so the call ran.
    LampImpl impl = keep(new LampImpl(id, "left"));
    daemon.live = new MarshalledObject<>(impl);
    Lamp lamp =
        (Lamp)
            Activatable.register(new ActivationDesc(group, LampImpl.class.getName(), null, null));

    assertThatExceptionOfType(ServerException.class).isThrownBy(lamp::broken);
    assertThat(daemon.calls).containsExactly("activate false");
  }

  @Test
  void failedActivationEndsTheCall() throws Exception {
    Lamp lamp =
        (Lamp)
            Activatable.register(new ActivationDesc(group, LampImpl.class.getName(), null, null));
    daemon.refusal = new ActivationException("group does not start");
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(lamp::name)
        .withMessageStartingWith("The object cannot be activated")
        .withCause(daemon.refusal);

    daemon.refusal = new UnknownObjectException("unregistered");
    assertThatExceptionOfType(NoSuchObjectException.class)
        .isThrownBy(lamp::name)
        .withMessage("The object is not registered: unregistered");

    daemon.refusal = null;
    daemon.unreachable = new ConnectException("no daemon");
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(lamp::name)
        .isSameAs(daemon.unreachable);
  }

  @Test
  void proxiesOfOneIdentityAreEqual() throws Exception {
    ActivationID id = registered();
    Remote one = Activatable.exportObject(keep(new Bulb("1")), id, 0, sockets, sockets);
    Remote two = Activatable.exportObject(keep(new Bulb("2")), id, 0, sockets, sockets);
    Remote other = Activatable.exportObject(keep(new Bulb("3")), registered(), 0, sockets, sockets);

    assertThat(one).isEqualTo(two).hasSameHashCodeAs(two).isNotEqualTo(other).isNotEqualTo("x");
    assertThat(one.toString()).startsWith("Activatable[");
  }

  @Test
  void proxyAnsweredByTheDaemonMayItselfBeActivatable() throws Exception {
    UnicastRemoteObject.exportObject(keep(daemon), 0, sockets, sockets);
    ActivationID id = registered();
    Remote proxy = Activatable.exportObject(keep(new Bulb("bulb")), id, 0, sockets, sockets);
    daemon.live = new MarshalledObject<>(proxy);
    Lamp lamp = (Lamp) Activatable.register(new ActivationDesc(group, name(), null, null));

    assertThat(lamp.name()).isEqualTo("bulb");

    daemon.live =
        new MarshalledObject<>(Activatable.register(new ActivationDesc(group, name(), null, null)));
    Lamp never = (Lamp) Activatable.register(new ActivationDesc(group, name(), null, null));
    assertThatExceptionOfType(ActivateFailedException.class)
        .isThrownBy(never::name)
        .withMessage("The activator answered with a proxy that is not live.");
  }

  private static String name() {
    return Bulb.class.getName();
  }

  @Test
  void constructorRegistersExportsAndReports() throws Exception {
    LampImpl lamp = keep(new LampImpl("left"));
    ActivationDesc desc = daemon.objects.get(lamp.id());

    assertThat(desc.getClassName()).isEqualTo(LampImpl.class.getName());
    assertThat(desc.getRestartMode()).isTrue();
    assertThat(desc.getData().get()).isEqualTo("on");
    assertThat(daemon.calls).containsExactly("activeObject");
    assertThat(((Lamp) lamp.id().activate(false)).name()).isEqualTo("left");
    assertThat(Activatable.inactive(lamp.id())).isTrue();
    Activatable.unregister(lamp.id());
    assertThat(daemon.objects).isEmpty();
    assertThatExceptionOfType(UnknownObjectException.class)
        .isThrownBy(() -> Activatable.unregister(lamp.id()));
  }

  @Test
  void objectThatCannotBeReportedToTheDaemonIsNeitherRegisteredNorExported() {
    daemon.unreachable = new ConnectException("no daemon");
    Bulb bulb = new Bulb("bulb");

    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(() -> Activatable.exportObject(bulb, null, null, false, 0, sockets, sockets));
    assertThat(daemon.objects).isEmpty();
    assertThatExceptionOfType(NoSuchObjectException.class)
        .isThrownBy(() -> Activatable.unexportObject(bulb, true));
  }

  @Test
  void unsuitableClassesAreNotRegistered() {
    for (String name : List.of("no.such.Lamp", "java.lang.String")) {
      assertThatExceptionOfType(ActivationException.class)
          .isThrownBy(() -> Activatable.register(new ActivationDesc(group, name, null, null)))
          .withMessageStartingWith("The class " + name + " cannot be registered as activatable");
    }
    assertThat(daemon.objects).isEmpty();
  }

  @Test
  void withoutAGroupNothingIsExportedOrPutToSleep() {
    FreshJvm.pretend();
    String sentence =
        "This JVM has no active activation group: call ActivationGroup.createGroup first.";

    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> Activatable.exportObject(new Bulb("x"), null, null, false, 0))
        .withMessage(sentence);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> Activatable.inactive(new ActivationID(daemon)))
        .withMessage(sentence);
  }
}
