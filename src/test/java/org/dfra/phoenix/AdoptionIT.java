package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.awaitility.Awaitility.await;

import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.dfra.core.time.StallProbe;
import org.dfra.core.time.Timing;
import org.dfra.river.phoenix.GroupStatus;
import org.dfra.river.phoenix.GroupStatus.State;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/**
 * Phoenix ends, one way or another, and the next one takes up what it finds. A phoenix that is left
 * over, its groups forgotten, serves the next test.
 *
 * <p>Short: a restart with 250 objects. {@code dfra.full}: with 1000.
 */
class AdoptionIT {

  private static final int OBJECTS = Boolean.getBoolean("dfra.full") ? 1000 : 250;

  @TempDir static Path temp;
  private static @Nullable PhoenixFixture left;
  private PhoenixFixture phoenix;
  private String saidBefore;

  @BeforeEach
  void start() throws Exception {
    PhoenixFixture used = left;
    phoenix =
        used != null
            ? used
            : new PhoenixFixture(
                    Files.createTempDirectory(temp, "phoenix"),
                    "restartDelay=10L",
                    "unexportTimeout=1000L")
                .withRegistry();
    left = phoenix;
    if (used == null) {
      phoenix.start();
    }
    saidBefore = phoenix.output();
  }

  @AfterEach
  void end() throws Exception {
    left = null;
    boolean isCleared = false;
    try {
      if (phoenix.process().isAlive()) {
        phoenix.clear();
        isCleared = true;
      }
    } finally {
      if (!isCleared) {
        phoenix.close();
      }
    }
    phoenix.assertNoDeviceConflict();
    if (isCleared) {
      left = phoenix;
    }
  }

  @AfterAll
  static void endTheLast() {
    if (left != null) {
      left.close();
    }
  }

  @Test
  void livingGroupsAreTakenBackWithWhatTheyHaveAndTheirLaterDeathIsNoticed() throws Exception {
    Beacon marked = phoenix.beacon(phoenix.group("marked"), ok("marked"), true);
    ActivationGroupID group = phoenix.group("other");
    ActivationID id = phoenix.register(group, ok("other"), false);
    Beacon other = (Beacon) id.activate(false);
    phoenix.group("idle");
    long markedPid = marked.pid();
    long otherPid = other.pid();
    phoenix.kill();
    assertThat(phoenix.vms()).as("after kill -9").containsOnlyKeys("marked", "other");
    assertThat(marked.pid()).as("groups serve without phoenix").isEqualTo(markedPid);

    phoenix.start();
    assertThat(phoenix.admin().activeObjects(group)).containsExactly(id);
    assertThat(phoenix.admin().unregisterInactive(id)).as("nobody has asked the group").isFalse();
    assertThat(phoenix.admin().activeProxy(id).get()).isEqualTo(other);
    assertThat(phoenix.vms("marked")).containsExactly(markedPid);
    assertThat(phoenix.vms("other")).containsExactly(otherPid);
    for (String name : List.of("marked", "other")) {
      GroupStatus status = phoenix.status(name);
      assertThat(status.adopted()).as("%s", status).isTrue();
      assertThat(status.state()).as("%s", status).isEqualTo(State.ACTIVE);
    }
    assertThat(phoenix.status("idle").adopted()).isFalse();
    assertThat(marked.pid()).isEqualTo(markedPid);

    PhoenixFixture.kill(markedPid);
    GroupStatus next =
        phoenix.awaitStatus("marked", s -> s.state() == State.ACTIVE && s.pid() != markedPid);
    assertThat(next.adopted()).isFalse();
    assertThat(next.lastCrash()).contains("a former phoenix's child");
    assertThat(marked.pid()).isEqualTo(next.pid());
    PhoenixFixture.kill(otherPid);
    assertThat(other.pid()).as("on call").isNotEqualTo(otherPid);
    assertThat(phoenix.vms("other")).hasSize(1);
  }

  @Test
  void whatEndedWhilePhoenixWasAwayComesBackIfMarkedAndElseOnCall() throws Exception {
    Beacon marked = phoenix.beacon(phoenix.group("marked"), ok("marked"), true);
    Beacon other = phoenix.beacon(phoenix.group("other"), ok("other"), false);
    Beacon leaver = phoenix.beacon(phoenix.group("leaver"), ok("leaver"), false);
    long pid = marked.pid();
    long left = leaver.pid();
    phoenix.kill();
    PhoenixFixture.kill(pid);
    PhoenixFixture.kill(other.pid());
    leaver.deactivate();
    PhoenixFixture.awaitDeath(left);
    phoenix.start();
    phoenix.awaitStatus("marked", s -> s.state() == State.ACTIVE);
    assertThat(phoenix.status("other").state()).isEqualTo(State.IDLE);
    assertThat(marked.pid()).isNotEqualTo(pid);
    assertThat(other.pid()).isPositive();
    assertThat(leaver.pid()).as("what became inactive is made again").isNotEqualTo(left);
    assertThat(phoenix.vms("leaver")).hasSize(1);
  }

  /** One of them goes on and reports; one ends, and is replaced for the one who waits. */
  @Test
  void groupsThatWereStartingAreTakenBackAndReportOrAreReplaced() throws Exception {
    ActivationID id = phoenix.register(phoenix.group("starting"), ok("starting"), false);
    ActivationID victim = phoenix.register(phoenix.group("dying"), ok("dying"), false);
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      Future<?> lost = threads.submit(() -> id.activate(false));
      long pid = phoenix.awaitStatus("starting", s -> s.pid() > 0).pid();
      PhoenixFixture.signal("STOP", pid);
      assertThat(phoenix.status("starting").state()).isEqualTo(State.STARTING);
      threads.submit(() -> victim.activate(false));
      long dying = phoenix.awaitStatus("dying", s -> s.pid() > 0).pid();
      PhoenixFixture.signal("STOP", dying);
      phoenix.kill();
      assertThatExceptionOfType(java.util.concurrent.ExecutionException.class)
          .isThrownBy(lost::get);
      phoenix.start();
      GroupStatus status = phoenix.status("starting");
      assertThat(status.adopted()).as("%s", status).isTrue();
      assertThat(status.state()).as("%s", status).isEqualTo(State.STARTING);
      Future<?> waiting = threads.submit(() -> id.activate(false));
      PhoenixFixture.signal("CONT", pid);
      assertThat(((Beacon) waiting.get()).pid()).isEqualTo(pid);
      assertThat(phoenix.vms("starting")).containsExactly(pid);

      Future<?> replaced = threads.submit(() -> victim.activate(false));
      PhoenixFixture.kill(dying);
      assertThat(((Beacon) replaced.get()).pid()).isNotEqualTo(dying);
      assertThat(phoenix.vms("dying")).hasSize(1);
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void shutdownEndsEveryProcessAndFreesThePorts() throws Exception {
    Beacon one = phoenix.beacon(phoenix.group("one"), ok("one"), true);
    Beacon stopped = phoenix.beacon(phoenix.group("stopped"), ok("stopped"), true);
    PhoenixFixture.signal("STOP", stopped.pid());
    phoenix.system().shutdown();
    assertThat(phoenix.process().waitFor(40, TimeUnit.SECONDS)).as("phoenix ends").isTrue();
    assertThat(phoenix.process().exitValue()).isZero();
    assertThat(phoenix.vms()).as("processes left").isEmpty();
    new ServerSocket(phoenix.port, 1, InetAddress.getLoopbackAddress()).close();
    new ServerSocket(phoenix.registryPort, 1, InetAddress.getLoopbackAddress()).close();
    assertThat(phoenix.output().substring(saidBefore.length()))
        .doesNotContain("did not close well");

    phoenix.start();
    phoenix.awaitStatus("one", s -> s.state() == State.ACTIVE);
    assertThat(one.pid()).isPositive();
  }

  @Test
  @EnabledIfSystemProperty(named = "dfra.full", matches = "true", disabledReason = "starts phoenix")
  void terminationEndsTheProcessesToo() throws Exception {
    phoenix.beacon(phoenix.group("one"), ok("one"), true);
    phoenix.process().destroy();
    assertThat(phoenix.process().waitFor(40, TimeUnit.SECONDS)).as("phoenix ends").isTrue();
    assertThat(phoenix.vms()).as("processes left").isEmpty();
  }

  @Test
  void terminationWhileAGroupIsLaunchedLeavesNoProcess() throws Exception {
    ExecutorService threads = Executors.newCachedThreadPool();
    try {
      for (int i = 0; i < 3; i++) {
        ActivationID id = phoenix.register(phoenix.group("late" + i), "ok", false);
        threads.submit(() -> id.activate(false));
      }
      phoenix.process().destroy();
      assertThat(phoenix.process().waitFor(40, TimeUnit.SECONDS)).as("phoenix ends").isTrue();
      await("no process is left")
          .atMost(PhoenixFixture.PATIENCE)
          .untilAsserted(() -> assertThat(phoenix.vms()).isEmpty());
    } finally {
      threads.shutdownNow();
    }
  }

  @Test
  void secondPhoenixOnTheSameFolderIsRefusedAndHarmsNothing() throws Exception {
    Beacon one = phoenix.beacon(phoenix.group("one"), ok("one"), true);
    long pid = one.pid();
    try (PhoenixFixture second =
        new PhoenixFixture(phoenix.folder) {
          @Override
          public void close() {
            process().destroyForcibly();
          }
        }) {
      assertThat(second.startInVain())
          .contains("Phoenix cannot start: The journal in " + phoenix.journal())
          .containsPattern(
              "process " + phoenix.process().pid() + " of user \\S+ still owns this journal");
    }
    phoenix.group("two");
    phoenix.kill();
    phoenix.start();
    assertThat(phoenix.admin().groupStatus()).hasSize(2);
    assertThat(one.pid()).isEqualTo(pid);
  }

  @Test
  void manyObjectsAreThereSoonAfterARestart() throws Exception {
    ActivationGroupID group = phoenix.group("many");
    for (int i = 0; i < OBJECTS; i++) {
      phoenix.register(group, "ok", false);
    }
    phoenix.kill();
    try (StallProbe probe = StallProbe.start()) {
      StallProbe.Stopwatch began = probe.stopwatch();
      phoenix.start();
      Timing ready = began.stop();
      System.out.println("AdoptionIT: ready after " + ready.took() + " with " + OBJECTS);
      assertThat(phoenix.admin().getActivatableObjects(group)).hasSize(OBJECTS);
      // The figure to keep is 2 s on an idle machine, with 1000 objects.
      ready.requireWithin("phoenix's start with " + OBJECTS + " objects", Duration.ofSeconds(8));
    }
  }

  private String ok(String device) {
    return "ok " + phoenix.device(device);
  }
}
