package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.io.ObjectOutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivateFailedException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.dfra.river.phoenix.ActivationGroupImpl;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.GroupStatus.State;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Groups in virtual machines of their own.
 *
 * <p>Short: eight rounds of 32 threads, and one kill less. {@code dfra.full}: thirty rounds.
 */
class GroupVmIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final int ROUNDS = FULL ? 30 : 8;

  @TempDir static Path temp;
  private static PhoenixFixture phoenix;

  /** A group that no test harms, and its only object. */
  private static ActivationGroupID quietGroup;

  private static Beacon quiet;

  @BeforeAll
  static void start() throws Exception {
    phoenix =
        new PhoenixFixture(
                temp,
                "restartLimit=3",
                "restartDelay=50L",
                "restartHoldOff=8000L",
                "restartWindow=20000L",
                "unexportTimeout=1000L",
                "permittedCommands=new String[] { \"*\" }",
                "permittedOptions=new String[] { \"*\" }")
            .start();
    quietGroup = phoenix.group("quiet");
    quiet = phoenix.beacon(quietGroup, "ok " + phoenix.device("quiet"), false);
  }

  @AfterAll
  static void end() {
    phoenix.close();
  }

  @AfterEach
  void noDeviceHadTwoOwners() throws Exception {
    phoenix.assertNoDeviceConflict();
  }

  @Test
  void thirtyTwoThreadsMakeOneInstanceInColdAndLiveGroup() throws Exception {
    ActivationGroupID group = phoenix.group("crowd");
    ActivationID cold = phoenix.register(group, "ok " + phoenix.device("crowd"), false);
    List<Beacon> first = activateByThirtyTwo(cold);
    assertThat(first.get(0).instances()).as("instances in a cold group").isEqualTo(1);
    assertThat(phoenix.vms("crowd")).hasSize(1);
    for (int round = 2; round <= ROUNDS; round++) {
      List<Beacon> more = activateByThirtyTwo(phoenix.register(group, "ok", false));
      assertThat(more.get(31).instances()).as("instances after round %s", round).isEqualTo(round);
    }
    assertThat(phoenix.status("crowd").incarnation()).isEqualTo(1);
  }

  private static List<Beacon> activateByThirtyTwo(ActivationID id) throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(32);
    try {
      Callable<Beacon> call = () -> (Beacon) id.activate(false);
      List<Beacon> found = new ArrayList<>();
      for (Future<Beacon> each : threads.invokeAll(java.util.Collections.nCopies(32, call))) {
        found.add(each.get());
      }
      assertThat(found).allSatisfy(each -> assertThat(each).isEqualTo(found.get(0)));
      return found;
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void killedInEachStateTheNextActivationWorksAndThereIsNeverASecond() throws Exception {
    ActivationGroupID group = phoenix.group("victim");
    ActivationID id = phoenix.register(group, "ok " + phoenix.device("victim"), false);
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      Future<?> activated = threads.submit(() -> id.activate(false));
      PhoenixFixture.kill(
          phoenix.awaitStatus("victim", s -> s.state() == State.STARTING && s.pid() > 0).pid());
      assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
          .as("starting")
          .isThrownBy(activated::get)
          .withMessageContaining("ended (exit code 137)");
      Beacon beacon = (Beacon) id.activate(false);
      assertThat(phoenix.vms("victim")).as("after a kill while starting").hasSize(1);

      if (FULL) { // every day AdoptionIT and RiverIT kill one that is active
        long active = beacon.pid();
        PhoenixFixture.kill(active);
        assertThat(beacon.pid()).as("after a kill while active").isNotEqualTo(active);
        assertThat(phoenix.vms("victim")).containsExactly(beacon.pid());
      }

      long leaving = beacon.pid();
      beacon.deactivate();
      phoenix.awaitStatus("victim", s -> s.state() == State.LEAVING || s.state() == State.IDLE);
      PhoenixFixture.kill(leaving);
      assertThat(beacon.pid()).as("after a kill while leaving").isNotEqualTo(leaving);
      assertThat(phoenix.vms("victim")).containsExactly(beacon.pid());
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void groupWithNothingLeftEndsAndComesBackOnCall() throws Exception {
    ActivationGroupID group = phoenix.group("leaver");
    Beacon one = phoenix.beacon(group, "ok " + phoenix.device("leaver"), false);
    Beacon other = phoenix.beacon(group, "ok " + phoenix.device("leaver"), false);
    long pid = one.pid();
    one.deactivate();
    assertThat(other.pid()).as("the other one keeps the group").isEqualTo(pid);
    assertThat(one.pid()).as("made again in the living group").isEqualTo(pid);
    one.deactivate();
    other.deactivate();
    PhoenixFixture.awaitDeath(pid);
    assertThat(phoenix.awaitStatus("leaver", s -> s.state() == State.IDLE).totalCrashes())
        .as("crashes")
        .isZero();
    assertThat(one.pid()).isNotEqualTo(pid);
  }

  @Test
  void unregisteredObjectCanStillBecomeInactive() throws Exception {
    ActivationGroupID group = phoenix.group("orphan");
    ActivationID id = phoenix.register(group, "ok", false);
    Beacon beacon = (Beacon) id.activate(false);
    long pid = beacon.pid();
    phoenix.system().unregisterObject(id);
    beacon.deactivate();
    PhoenixFixture.awaitDeath(pid);
    assertThatExceptionOfType(java.rmi.NoSuchObjectException.class).isThrownBy(beacon::pid);
  }

  @Test
  void slowConstructorDelaysNobodyElse() throws Exception {
    ActivationGroupID group = phoenix.group("slow");
    Beacon quick = phoenix.beacon(group, "ok", false);
    Beacon leaver = phoenix.beacon(group, "ok", false);
    ActivationID slow = phoenix.register(group, "slow " + phoenix.device("slow"), false);
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      Future<?> being = threads.submit(() -> slow.activate(false));
      await("the slow constructor runs")
          .atMost(PhoenixFixture.PATIENCE)
          .until(() -> Files.exists(Path.of(phoenix.device("slow") + ".log")));
      long began = System.nanoTime();
      leaver.deactivate();
      for (int i = 0; i < 5; i++) {
        phoenix.beacon(group, "ok", false);
      }
      long millis = (System.nanoTime() - began) / 1_000_000;
      assertThat(being.isDone()).as("the slow one is done after %s ms", millis).isFalse();
      Files.createFile(Path.of(phoenix.device("slow") + ".go"));
      being.get();
      assertThat(quick.pid()).isEqualTo(phoenix.status("slow").pid());
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void whyAnObjectCannotBeMadeReachesTheClientOfItsProxy() throws Exception {
    ActivationGroupID group = phoenix.group("broken");
    ActivationID id = phoenix.register(group, "ok", false);
    Beacon beacon = (Beacon) id.activate(false);
    PhoenixFixture.kill(beacon.pid()); // from now on each call wants the object made
    assertFailure(
        beacon, id, PhoenixFixture.desc(group, "throws", false), "the receiver is not plugged in");
    assertFailure(
        beacon,
        id,
        new ActivationDesc(group, "org.example.Missing", null, null),
        "org.example.Missing: its class is not on the group's class path");
    assertFailure(
        beacon,
        id,
        new ActivationDesc(group, BeaconImpl.WithoutConstructor.class.getName(), null, null),
        "it has no constructor (ActivationID, MarshalledObject)");
    assertFailure(
        beacon,
        id,
        new ActivationDesc(group, BeaconImpl.NotRemote.class.getName(), null, null),
        "NotRemote does not implement java.rmi.Remote");
    phoenix.system().setActivationDesc(id, PhoenixFixture.desc(group, "ok", false));
    assertThat(beacon.pid()).as("mended, it works").isPositive();
  }

  private void assertFailure(Beacon beacon, ActivationID id, ActivationDesc desc, String words)
      throws Exception {
    phoenix.system().setActivationDesc(id, desc);
    assertThatExceptionOfType(ActivateFailedException.class)
        .as("%s", desc.getClassName())
        .isThrownBy(beacon::pid)
        .withCauseInstanceOf(ActivationException.class)
        .satisfies(e -> assertThat(e.getCause()).hasMessageContaining(words));
  }

  @Test
  void objectThatKillsItsMachineIsHeldOffAndComesBackWhenMended() throws Exception {
    ActivationGroupID group = phoenix.group("bomb");
    ActivationID id = phoenix.register(group, "halts " + phoenix.device("bomb"), true);
    assertThatExceptionOfType(ActivationException.class).isThrownBy(() -> id.activate(false));
    GroupStatus heldOff = phoenix.awaitStatus("bomb", s -> s.heldOffUntil() != null);
    assertThat(heldOff.incarnation()).as("virtual machines started").isEqualTo(3);
    assertThat(heldOff.recentCrashes()).isEqualTo(3);
    assertThat(heldOff.lastCrash()).contains("exit code 77");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> id.activate(false))
        .withMessageContaining("crashed 3 times within 20 s and is held off until")
        .withMessageContaining("exit code 77");
    assertThat(Files.readAllLines(Path.of(phoenix.device("bomb") + ".log")))
        .as("who opened the device")
        .hasSize(3);
    phoenix
        .system()
        .setActivationDesc(id, PhoenixFixture.desc(group, "ok " + phoenix.device("bomb"), true));
    phoenix.awaitStatus("bomb", s -> s.heldOffUntil() == null);
    assertThat(((Beacon) id.activate(false)).pid()).isPositive();
    assertThat(phoenix.status("bomb").incarnation()).isEqualTo(4);
  }

  @Test
  void restartedObjectsComeBackByThemselvesAndOthersOnCall() throws Exception {
    ActivationGroupID group = phoenix.group("watch");
    Beacon marked = phoenix.beacon(group, "ok " + phoenix.device("watch"), true);
    Beacon other = phoenix.beacon(group, "ok", false);
    long pid = marked.pid();
    PhoenixFixture.kill(pid);
    long next =
        phoenix.awaitStatus("watch", s -> s.state() == State.ACTIVE && s.pid() != pid).pid();
    await("the marked object").atMost(PhoenixFixture.PATIENCE).until(() -> marked.pid() == next);
    assertThat(marked.instances()).as("objects that came back without a call").isEqualTo(1);
    assertThat(other.pid()).isEqualTo(next);
    assertThat(other.instances()).isEqualTo(2);
  }

  @Test
  void secondVirtualMachineIsRefusedTheGroupByItsLock() throws Exception {
    ActivationGroupDesc desc = phoenix.system().getActivationGroupDesc(quietGroup);
    // The same command as phoenix gave, but with an output file that phoenix does not write to.
    List<String> command = new ArrayList<>(PhoenixFixture.arguments(quiet.pid()));
    Path output = temp.resolve("second.log");
    command.replaceAll(
        a ->
            a.startsWith("-Dorg.dfra.phoenix.output=") ? "-Dorg.dfra.phoenix.output=" + output : a);
    Process second =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(temp.resolve("second.vm.log").toFile())
            .start();
    try (ObjectOutputStream out = new ObjectOutputStream(second.getOutputStream())) {
      out.writeObject(quietGroup);
      out.writeObject(
          new ActivationGroupDesc(
              ActivationGroupImpl.class.getName(), null, null, null, desc.getCommandEnvironment()));
      out.writeLong(1);
    }
    assertThat(second.waitFor(20, TimeUnit.SECONDS)).isTrue();
    assertThat(second.exitValue())
        .as("exit code; it said %s", Files.readString(output))
        .isEqualTo(11);
    assertThat(output)
        .content()
        .containsPattern("process " + quiet.pid() + " of user \\S+ still owns this group")
        .contains("a second one is refused until that one has ended");
    assertThat(quiet.pid()).isPositive();
  }

  @Test
  void processThatNeverReceivesItsGroupEnds() throws Exception {
    Process groupless = new ProcessBuilder(PhoenixFixture.arguments(quiet.pid())).start();
    groupless.getOutputStream().close();
    assertThat(groupless.waitFor(20, TimeUnit.SECONDS)).isTrue();
    assertThat(groupless.exitValue()).isEqualTo(10);
  }

  @Test
  void outputGoesIntoTheGroupsFileAndTheMachinesOwnBesideIt() throws Exception {
    ActivationGroupID group = phoenix.group("talker", "-XX:+UnlockDiagnosticVMOptions", "-version");
    ActivationID id = phoenix.register(group, "ok", false);
    assertThatExceptionOfType(ActivationException.class)
        .as("a machine that only prints its version")
        .isThrownBy(() -> id.activate(false))
        .withMessageContaining("ended (exit code 0)")
        .withMessageContaining(".vm.log");
    String name = phoenix.status("talker").name();
    assertThat(temp.resolve("output/" + name + ".vm.log")).content().contains("64-Bit Server VM");

    phoenix
        .system()
        .setActivationGroupDesc(
            group, PhoenixFixture.groupDesc("talker", org.dfra.river.bootstrap.JvmCommand.java()));
    Beacon beacon = (Beacon) id.activate(false);
    beacon.print("hello from the group");
    Path output = Path.of(phoenix.status("talker").output());
    assertThat(output).content().contains("hello from the group");
    beacon.print("red: \u001b[31m and \u202ebackwards"); // as a stranger's name may be
    assertThat(output).content().contains("red: \\u001b[31m and \\u202ebackwards");
    String line = "x".repeat(64 << 10);
    for (int i = 0; i < 70; i++) {
      beacon.print(line);
    }
    assertThat(Files.size(output)).as("bytes after 4.4 MB were printed").isLessThan(4 << 20);
    assertThat(output.resolveSibling(output.getFileName() + ".1")).exists();
  }

  @Test
  void badOptionOfTheMachineIsReportedFromItsOwnOutput() throws Exception {
    ActivationGroupID group = phoenix.group("option", "-XX:NoSuchOption");
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> phoenix.beacon(group, "ok", false))
        .withMessageContaining("ended (exit code 1)");
    assertThat(temp.resolve("output/" + phoenix.status("option").name() + ".vm.log"))
        .content()
        .contains("NoSuchOption");
  }

  @Test
  void commandThatDoesNotExistIsOneSentence() throws Exception {
    ActivationGroupID group =
        phoenix.system().registerGroup(PhoenixFixture.groupDesc("nojava", "/no/such/java"));
    assertThatExceptionOfType(ActivationException.class)
        .isThrownBy(() -> phoenix.beacon(group, "ok", true))
        .withMessageMatching(
            "(?s)group \\d+-nojava cannot be started: Cannot run program \"/no/such/java\""
                + ".*No such file or directory.*; correct its command.*");
  }
}
