package org.dfra.activation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroup;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationGroup_Stub;
import java.rmi.activation.ActivationID;
import java.rmi.activation.ActivationInstantiator;
import java.rmi.activation.UnknownGroupException;
import java.rmi.server.RemoteObject;
import java.rmi.server.UnicastRemoteObject;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A group's life in its JVM, and every reason for which it does not begin. */
class ActivationGroupTest {

  private final TestDaemon daemon = new TestDaemon();
  private final ActivationGroupID id = new ActivationGroupID(daemon);

  @BeforeEach
  void freshJvm() {
    FreshJvm.pretend();
    PlainGroup.last = null;
  }

  @AfterEach
  void unexport() {
    if (PlainGroup.last != null) {
      try {
        UnicastRemoteObject.unexportObject(PlainGroup.last, true);
      } catch (NoSuchObjectException e) {
        // The test ended its export.
      }
    }
    FreshJvm.pretend();
  }

  private PlainGroup create() throws ActivationException {
    return (PlainGroup) ActivationGroup.createGroup(id, desc(PlainGroup.class.getName()), 3);
  }

  private static ActivationGroupDesc desc(String name) {
    return new ActivationGroupDesc(name, null, null, null, null);
  }

  @Test
  void createdGroupIsOfTheClassNamedAndReportedActive() throws Exception {
    MarshalledObject<String> data = new MarshalledObject<>("front");
    PlainGroup group =
        (PlainGroup)
            ActivationGroup.createGroup(
                id, new ActivationGroupDesc(PlainGroup.class.getName(), null, data, null, null), 3);

    assertThat(group.given).isSameAs(data);
    assertThat(daemon.instantiator).isSameAs(group);
    assertThat(daemon.calls).containsExactly("activeGroup 3");
    assertThat(ActivationGroup.currentGroupID()).isSameAs(id);
    assertThat(ActivationGroup.getSystem()).isSameAs(daemon);
    assertThat(new ActivationDesc("GPS", null, null).getGroupID()).isSameAs(id);
  }

  @Test
  void groupPassesOnWhatItsObjectsDo() throws Exception {
    PlainGroup group = create();
    ActivationID object = daemon.registerObject(new ActivationDesc(id, "GPS", null, null));
    group.activeObject(object, group);

    assertThat(group.inactiveObject(object)).isTrue();
    assertThat(daemon.calls).containsExactly("activeGroup 3", "activeObject", "inactiveObject");
  }

  @Test
  void inactiveGroupLeavesThisJvmWithoutOne() throws Exception {
    PlainGroup group = create();
    group.end();

    assertThat(daemon.calls).endsWith("inactiveGroup 3");
    assertThat(ActivationGroup.currentGroupID()).isNull();
    assertThatExceptionOfType(UnknownGroupException.class)
        .isThrownBy(group::end)
        .withMessage("This group is not active, so it cannot become inactive.");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> group.inactiveObject(new ActivationID(daemon)))
        .withMessage(
            "This group is not active: it has no monitor before createGroup has returned,"
                + " nor after inactiveGroup.");
  }

  @Test
  void secondGroupIsRefusedWhileThereIsOne() throws Exception {
    create();

    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(this::create)
        .withMessage(
            "This JVM already has an activation group, a org.dfra.activation.PlainGroup:"
                + " start another JVM for another group.");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      nullValues = "NULL",
      textBlock =
          """
          NULL                | The group descriptor has no class name, and java.rmi.activation has no default group class: give ActivationGroupDesc the name of a concrete subclass of ActivationGroup.
          no.such.Group       | The group class no.such.Group cannot be loaded from null
          java.lang.String    | The group class java.lang.String is not a subclass of java.rmi.activation.ActivationGroup
          $WithoutConstructor | The group class CLASS must be public and have a public constructor (ActivationGroupID, MarshalledObject)
          $Hidden             | The group class CLASS must be public and have a public constructor (ActivationGroupID, MarshalledObject)
          $Abstract           | The group class CLASS is abstract
          $Failing            | The constructor of the group class CLASS failed; nested exception is:
          """)
  void unsuitableClassesAreRefused(String name, String sentence) {
    String group = name != null && name.startsWith("$") ? PlainGroup.class.getName() + name : name;
    String wanted = sentence.replace("CLASS", String.valueOf(group));

    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> ActivationGroup.createGroup(id, desc(group), 1))
        .withMessageStartingWith(wanted);
    assertThat(daemon.calls).isEmpty();
    assertThat(ActivationGroup.currentGroupID()).isNull();
  }

  @Test
  void locationThatIsNoUrlIsRefused() {
    ActivationGroupDesc nowhere = new ActivationGroupDesc("no.such.Group", "::", null, null, null);

    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> ActivationGroup.createGroup(id, nowhere, 1))
        .withMessageStartingWith("The group class no.such.Group cannot be loaded from ::");
  }

  @Test
  void groupTheSystemDoesNotTakeIsUnexportedAgain() {
    daemon.unreachable = new RemoteException("down");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(this::create)
        .withMessageStartingWith(
            "The activation system cannot be notified that the group is active")
        .withCause(daemon.unreachable);
    assertThat(PlainGroup.last).matches(ActivationGroupTest::unexported, "is unexported");

    daemon.unreachable = null;
    daemon.refusal = new UnknownGroupException("unregistered");
    assertThatExceptionOfType(UnknownGroupException.class).isThrownBy(this::create);
    assertThat(PlainGroup.last).matches(ActivationGroupTest::unexported, "is unexported");
    assertThat(ActivationGroup.currentGroupID()).isNull();
  }

  /** As on a busy computer: the report arrived, and its answer came after the deadline. */
  @Test
  void reportWhoseAnswerIsLateIsMadeAgain() throws Exception {
    daemon.lateAnswers = 2;
    PlainGroup group = create();
    assertThat(daemon.calls).containsExactly("activeGroup 3", "activeGroup 3", "activeGroup 3");
    assertThat(daemon.instantiator).isSameAs(group);
    assertThat(ActivationGroup.currentGroupID()).isSameAs(id);
  }

  @Test
  void reportIsNotMadeAgainWhereNothingListens() {
    daemon.unreachable = new java.rmi.ConnectException("refused");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(this::create)
        .withCause(daemon.unreachable);
    assertThat(daemon.reports).isEqualTo(1);
  }

  /** The systems of River's own tests give none. */
  @Test
  void groupIsCreatedWhereTheSystemGivesNoMonitor() throws Exception {
    daemon.monitor = null;
    PlainGroup group = create();
    assertThat(ActivationGroup.currentGroupID()).isSameAs(id);
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> group.inactiveObject(new ActivationID(daemon)))
        .withMessage(
            "The activation system returned no monitor for this group, so the group cannot report to it.");
    assertThatExceptionOfType(UnknownGroupException.class)
        .isThrownBy(group::end)
        .withMessageStartingWith("The activation system returned no monitor for this group");
    assertThat(ActivationGroup.currentGroupID()).as("ended all the same").isNull();
  }

  @Test
  void groupOfNoSystemIsRefusedBeforeItIsConstructed() {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(
            () ->
                ActivationGroup.createGroup(
                    new ActivationGroupID(null), desc(PlainGroup.class.getName()), 1))
        .withMessage("The group's ID has no activation system: register the group with one first.");
    assertThat(PlainGroup.last).isNull();
  }

  @Test
  void groupWhoseConstructorFailsAfterItsExportIsUnexportedAgain() {
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(
            () -> ActivationGroup.createGroup(id, desc(PlainGroup.FailingLate.class.getName()), 1));
    assertThat(PlainGroup.FailingLate.failed)
        .matches(ActivationGroupTest::unexported, "is unexported");
  }

  @Test
  void refusedGroupIsClosedIfItCanBe() throws Exception {
    daemon.refusal = new UnknownGroupException("unregistered");
    PlainGroup.Closing.closed = 0;
    String closing = PlainGroup.Closing.class.getName();
    assertThatExceptionOfType(UnknownGroupException.class)
        .isThrownBy(() -> ActivationGroup.createGroup(id, desc(closing), 1))
        .satisfies(
            refusal ->
                assertThat(refusal.getSuppressed())
                    .singleElement()
                    .matches(e -> "half closed".equals(e.getMessage())));
    assertThat(PlainGroup.Closing.closed).isEqualTo(1);
  }

  @Test
  void refusedGroupLeavesNoJvmAlive(@TempDir Path folder) throws Exception {
    ChildJvm child =
        ChildJvm.run(
            folder,
            List.of(
                "-Xbootclasspath/a:" + System.getProperty("dfra.boot-class-path"),
                "-cp",
                System.getProperty("java.class.path"),
                RefusedGroupMain.class.getName()));
    assertThat(child.printed()).contains("refused FailingLate").contains("refused PlainGroup");
    assertThat(child.exit()).isZero();
  }

  private static boolean unexported(ActivationGroup group) {
    try {
      return RemoteObject.toStub(group) == null;
    } catch (NoSuchObjectException e) {
      return true;
    }
  }

  @Test
  void daemonReachesTheGroupThroughItsStub() throws Exception {
    PlainGroup group = create();
    Object stub = new MarshalledObject<>(group).get();

    assertThat(stub).isInstanceOf(ActivationGroup_Stub.class);
    // The identity crosses JRMP too, so its activator has to be exported by it.
    LoopbackSockets sockets = new LoopbackSockets();
    UnicastRemoteObject.exportObject(daemon, 0, sockets, sockets);
    try {
      ActivationID object = new ActivationID(daemon);
      ActivationDesc desc = new ActivationDesc(new ActivationGroupID(null), "GPS", null, null);
      assertThatExceptionOfType(ActivationException.class)
          .isThrownBy(() -> ((ActivationInstantiator) stub).newInstance(object, desc))
          .withMessage("asked for a GPS");
    } finally {
      UnicastRemoteObject.unexportObject(daemon, true);
    }
  }

  @Test
  void groupListensOnTheLoopbackAddressOnly() throws Exception {
    String stub = RemoteObject.toStub(create()).toString();
    Matcher port = Pattern.compile("endpoint:\\[[^,]*:(\\d+)[,\\]]").matcher(stub);
    assertThat(port.find()).as(stub).isTrue();
    int number = Integer.parseInt(port.group(1));

    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), number)) {
      assertThat(socket.isConnected()).isTrue();
    }
    // All of 127.0.0.0/8 is this host: a socket bound to every address would answer here.
    try (Socket socket = new Socket()) {
      assertThatExceptionOfType(ConnectException.class)
          .isThrownBy(() -> socket.connect(new InetSocketAddress("127.0.0.2", number), 2000));
    }
  }
}
