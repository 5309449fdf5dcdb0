package org.dfra.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationException;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationID;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Phoenix killed with -9 at random points of a stream of registrations, launches and deaths of
 * groups: nothing acknowledged is lost, and no group ever has two virtual machines at work.
 *
 * <p>{@code -Ddfra.full=true} kills 200 times, half of them in each of two phoenixes that run side
 * by side; otherwise one phoenix is killed 3 times. {@code -Ddfra.seed=n} repeats a run.
 */
class PhoenixCrashIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final int PHOENIXES = FULL ? 2 : 1;
  private static final int KILLS = FULL ? 100 : 3; // of each

  private static final List<String> GROUPS = List.of("left", "right");

  @TempDir Path temp;
  private final long seed = Long.getLong("dfra.seed", System.nanoTime());
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final List<Crashes> runs = new ArrayList<>();

  @AfterEach
  void end() throws Exception {
    runs.forEach(Crashes::close);
    threads.shutdownNow();
    boolean unused = threads.awaitTermination(60, TimeUnit.SECONDS);
    runs.forEach(Crashes::close); // what a run that failed has started meanwhile
  }

  @Test
  void everyAcknowledgedRegistrationSurvivesAndNoGroupIsDoubled() throws Exception {
    System.out.printf(
        "PhoenixCrashIT: %d times %d kills, -Ddfra.seed=%d%n", PHOENIXES, KILLS, seed);
    Random seeds = new Random(seed);
    for (int i = 0; i < PHOENIXES; i++) {
      runs.add(new Crashes(temp.resolve("phoenix" + i), new Random(seeds.nextLong())));
    }
    List<Future<?>> playing = new ArrayList<>();
    for (Crashes run : runs) {
      playing.add(
          threads.submit(
              () -> {
                run.play();
                return null;
              }));
    }
    for (Future<?> each : playing) {
      each.get();
    }
  }

  private static void pause(int millis) throws InterruptedException {
    // The moment of the kill is random time by intention, not a wait for an event.
    new CountDownLatch(1).await(millis, TimeUnit.MILLISECONDS);
  }

  /** One phoenix, killed again and again. */
  private final class Crashes implements AutoCloseable {

    private final Random random;
    private final PhoenixFixture phoenix;

    /** What phoenix has acknowledged; an operation under way counts as neither done nor not. */
    private final Map<ActivationID, ActivationDesc> objects = new LinkedHashMap<>();

    private final Set<ActivationID> uncertain = new HashSet<>();
    private final Map<String, ActivationGroupID> groups = new HashMap<>();
    private final Map<String, ActivationID> activated = new HashMap<>();
    private int acknowledged;
    private int launches;

    Crashes(Path folder, Random random) throws Exception {
      this.random = random;
      this.phoenix =
          new PhoenixFixture(
              Files.createDirectory(folder),
              "persistenceSnapshotThreshold=20",
              "restartLimit=1000",
              "restartDelay=1L",
              "restartMaxDelay=20L");
    }

    @Override
    public void close() {
      phoenix.close();
    }

    void play() throws Exception {
      phoenix.start();
      for (String name : GROUPS) {
        groups.put(name, phoenix.group(name));
        activated.put(name, register(name, true));
      }
      for (int kill = 1; kill <= KILLS; kill++) {
        String when = "kill " + kill + " of " + KILLS + ", -Ddfra.seed=" + seed;
        CompletableFuture<Void> streaming = stream();
        pause(random.nextInt(450));
        phoenix.kill();
        streaming.get(30, TimeUnit.SECONDS);
        assertNotDoubled(when + ", after the kill");
        phoenix.start();
        assertNotDoubled(when + ", after the restart");
        assertAllPresent(when);
      }
      for (String name : GROUPS) {
        Beacon beacon = (Beacon) activated.get(name).activate(false);
        assertThat(phoenix.vms(name))
            .as("at the end, -Ddfra.seed=%d", seed)
            .containsExactly(beacon.pid());
        launches += (int) phoenix.status(name).incarnation();
      }
      phoenix.assertNoDeviceConflict();
      System.out.printf(
          "PhoenixCrashIT: %d kills, %d acknowledged changes, %d launches, %d objects at the end%n",
          KILLS, acknowledged, launches, objects.size());
    }

    /** Changes registrations and has groups started until phoenix does not answer any more. */
    private CompletableFuture<Void> stream() {
      Random own = new Random(random.nextLong());
      boolean crash = own.nextBoolean();
      // Beside the stream, so that kills land in the window between a launch and its report.
      for (String name : GROUPS) {
        if (crash && own.nextBoolean()) {
          phoenix.vms(name).forEach(pid -> ProcessHandle.of(pid).ifPresent(this::killGroup));
        }
        CompletableFuture.runAsync(() -> activate(name), threads);
      }
      return CompletableFuture.runAsync(
          () -> {
            while (true) {
              try {
                change(own);
              } catch (RemoteException e) {
                return; // killed
              } catch (Exception e) {
                throw new AssertionError("-Ddfra.seed=" + seed, e);
              }
            }
          },
          threads);
    }

    private void killGroup(ProcessHandle process) {
      process.destroyForcibly();
    }

    private void activate(String name) {
      try {
        activated.get(name).activate(true);
      } catch (ActivationException | RemoteException e) {
        // Phoenix or the group was killed meanwhile: that is what this test is about.
      }
    }

    private void change(Random own) throws Exception {
      List<ActivationID> known = new ArrayList<>(objects.keySet());
      known.removeAll(activated.values());
      int what = own.nextInt(10);
      if (what < 6 || known.size() < 3) {
        register(GROUPS.get(own.nextInt(GROUPS.size())), false);
        return;
      }
      ActivationID object = known.get(own.nextInt(known.size()));
      uncertain.add(object);
      if (what < 8) {
        phoenix.system().unregisterObject(object);
        objects.remove(object);
      } else {
        ActivationDesc desc =
            PhoenixFixture.desc(objects.get(object).getGroupID(), "ok " + own.nextInt(), false);
        phoenix.system().setActivationDesc(object, desc);
        objects.put(object, desc);
      }
      uncertain.remove(object);
      acknowledged++;
    }

    private ActivationID register(String group, boolean restart) throws Exception {
      String mode = "ok " + phoenix.device(group);
      ActivationDesc desc = PhoenixFixture.desc(groups.get(group), mode, restart);
      ActivationID id = phoenix.system().registerObject(desc);
      objects.put(id, desc);
      acknowledged++;
      return id;
    }

    private void assertAllPresent(String when) throws Exception {
      Map<ActivationID, ActivationDesc> found = new HashMap<>();
      for (ActivationGroupID group : groups.values()) {
        found.putAll(phoenix.admin().getActivatableObjects(group));
      }
      for (Map.Entry<ActivationID, ActivationDesc> each : objects.entrySet()) {
        if (!uncertain.contains(each.getKey())) {
          assertThat(found).as(when).containsEntry(each.getKey(), each.getValue());
        }
      }
      // What was under way when phoenix was killed is now one or the other.
      objects.clear();
      objects.putAll(found);
      uncertain.clear();
    }

    /**
     * A virtual machine that was started but did not receive its group owns nothing and ends by
     * itself, so where there are two for a moment, one of them must go, and they must not both have
     * worked.
     */
    private void assertNotDoubled(String when) throws Exception {
      for (String name : GROUPS) {
        await(
                when
                    + ": virtual machines of "
                    + name
                    + " besides those that never received their group")
            .atMost(Duration.ofSeconds(20))
            .pollInterval(Duration.ofMillis(10))
            .pollDelay(Duration.ZERO)
            .untilAsserted(() -> assertThat(phoenix.vms(name)).hasSizeLessThanOrEqualTo(1));
      }
      phoenix.assertNoDeviceConflict();
    }
  }
}
