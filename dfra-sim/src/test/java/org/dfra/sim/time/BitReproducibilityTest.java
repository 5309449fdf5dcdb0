package org.dfra.sim.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.dfra.core.module.DeviceImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * A run is repeated bit by bit, whatever else the computer has to do: all the while there are
 * threads that are busy for a while, pause, and are busy again, so that a run is held up at ever
 * other places. {@code -Ddfra.full=true} repeats 50 times beside twice as many of them as
 * processors, otherwise twice beside one, and runs of two thirds of the simulated time; {@code
 * -Ddfra.seed=n} repeats the runs of a failure in the same form. In the short form one other
 * virtual machine has the other compilers and another collector.
 */
@Timeout(900)
class BitReproducibilityTest {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final int RUNS = FULL ? 50 : 2;
  private static final Duration LENGTH = Duration.ofSeconds(FULL ? 120 : 80); // of simulated time
  private static final int MOST_BUSY = 10_000_000; // ns
  private static final int LOAD = FULL ? 2 * Runtime.getRuntime().availableProcessors() : 1;

  /** Options of the other virtual machines; tests run in one with C1 and the serial collector. */
  private static final List<String> ELSEWHERE =
      FULL ? List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC") : List.of("-XX:+UseG1GC");

  private static final long SEED = Long.getLong("dfra.seed", new Random().nextLong());
  private static String once = ""; // the first run, which all tests compare with

  private final AtomicBoolean busy = new AtomicBoolean(true);
  private final List<Thread> load = new ArrayList<>();

  @BeforeEach
  void loadTheComputer() {
    for (int i = 0; i < LOAD; i++) {
      load.add(spawn(this::loadAndPause));
    }
  }

  /** Busy for an eighth of the time: as many threads as that hold up a run, but not for minutes. */
  private void loadAndPause() {
    Random spans = new Random();
    byte[] garbage = new byte[0];
    while (busy.get()) {
      long end = System.nanoTime() + spans.nextInt(MOST_BUSY);
      while (System.nanoTime() < end) {
        garbage = new byte[1000 + garbage.length % 7]; // keeps the collector busy too
      }
      LockSupport.parkNanos(7L * spans.nextInt(MOST_BUSY));
    }
  }

  @AfterEach
  void unload() throws InterruptedException {
    busy.set(false);
    for (Thread thread : load) {
      thread.join();
    }
  }

  private static Thread spawn(Runnable work) {
    Thread thread = new Thread(work, "load");
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  @Test
  void theSameSeedHasTheSameBytesAndReadingsInOneVirtualMachine() throws Exception {
    String first = first();
    assertThat(first)
        .as("-Ddfra.seed=%d: something to be repeated", SEED)
        .contains(
            " m12 >",
            " nmea <",
            " ubx >",
            " gpsd >",
            "delivered ",
            "rarely delivered ",
            " fault ",
            " changed ")
        .contains("NewReading", "RangeScan", "ReadinessChanged", "IncidentRecorded", "closed");
    for (int i = 1; i < RUNS; i++) {
      assertSame(first, run(SEED), "run " + i);
    }
  }

  @Test
  void theSameSeedHasTheSameBytesAndReadingsInTwoVirtualMachines() throws Exception {
    String here = SeededRobot.digest(first());
    for (String option : ELSEWHERE) {
      assertThat(runElsewhere(option)).as("-Ddfra.seed=%d, %s", SEED, option).isEqualTo(here);
    }
  }

  @Test
  void queriesOfTheDriversMeanwhileChangeNothing() throws Exception {
    String alone = first();
    try (SeededRobot robot = new SeededRobot(SEED, LENGTH)) {
      AtomicBoolean asks = new AtomicBoolean(true);
      CompletableFuture<Void> asker =
          CompletableFuture.runAsync(
              () -> ask(robot.drivers(), asks), BitReproducibilityTest::spawn);
      String watched = robot.run();
      asks.set(false);
      asker.get(60, TimeUnit.SECONDS);
      assertSame(alone, watched, "watched");
    }
  }

  private static void ask(List<DeviceImpl> drivers, AtomicBoolean asks) {
    while (asks.get()) {
      for (DeviceImpl driver : drivers) {
        assertThat(driver.parameters()).isNotEmpty();
        assertThat(driver.attributes()).isNotEmpty();
        assertThat(driver.history()).isNotNull();
        if (driver instanceof GPSSensor gps && driver.readiness().serves()) {
          askForAFix(gps);
        }
      }
    }
  }

  private static void askForAFix(GPSSensor gps) {
    try {
      assertThat(gps.fix()).isNotNull();
    } catch (NotReadyException e) {
      assertThat(e).as("it has lost it just now").hasMessageStartingWith("robot/");
    } catch (RemoteException e) {
      throw new AssertionError("it is in this virtual machine", e);
    }
  }

  @Test
  void anotherSeedIsAnotherRun() {
    assertThat(run(SEED + 1).equals(first())).as("-Ddfra.seed=%d", SEED).isFalse();
  }

  /** A run to compare with. */
  private static String first() {
    if (once.isEmpty()) {
      once = run(SEED);
    }
    return once;
  }

  private static String run(long seed) {
    try (SeededRobot robot = new SeededRobot(seed, LENGTH)) {
      return robot.run();
    }
  }

  private String runElsewhere(String option) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(
                System.getProperty("java.home") + "/bin/java",
                option,
                "-cp",
                System.getProperty("java.class.path"),
                SeededRobot.class.getName(),
                Long.toString(SEED),
                LENGTH.toString())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      String printed = process.inputReader(StandardCharsets.UTF_8).readLine();
      assertThat(process.waitFor(120, TimeUnit.SECONDS)).as("it ends").isTrue();
      return printed;
    } finally {
      process.destroyForcibly();
    }
  }

  /** Tells the first line that differs, not two records of a hundred thousand. */
  private void assertSame(String expected, String actual, String which) {
    if (expected.equals(actual)) {
      return;
    }
    List<String> before = expected.lines().toList();
    List<String> after = actual.lines().toList();
    int same = 0;
    while (same < Math.min(before.size(), after.size())
        && before.get(same).equals(after.get(same))) {
      same++;
    }
    assertThat(after.subList(same, Math.min(after.size(), same + 3)))
        .as("-Ddfra.seed=%d, %s differs from line %d on", SEED, which, same)
        .isEqualTo(before.subList(same, Math.min(before.size(), same + 3)));
    throw new AssertionError(
        "-Ddfra.seed=" + SEED + ", " + which + ": one is longer than the other");
  }
}
