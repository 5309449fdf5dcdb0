package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicIntegerArray;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Commanders come and go while all of their threads command as fast as they can. Each commands a
 * speed of its own, so the wheels show whose command it was.
 */
@Timeout(120)
class LostCommanderStressTest {

  private static final int COMMANDERS = Boolean.getBoolean("dfra.full") ? 5000 : 300;
  private static final int THREADS = 3;

  private final ScriptedWheels wheels = new ScriptedWheels(Scheduler.system(), Map.of());

  /** How many commands of each thread were refused. */
  private final AtomicIntegerArray refused = new AtomicIntegerArray(THREADS);

  /** Whose commands the threads give now: a number that is their speed, too. */
  private record Command(CommandKey key, double speed) {}

  private volatile Command current = new Command(new CommandKey(UUID.randomUUID()), 1e-3);
  private volatile boolean over;

  @Test
  void noCommandOfAnOldKeyIsExecutedAfterTheLeaseHasEnded() throws Exception {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    wheels.start();
    ExecutorService threads = Executors.newFixedThreadPool(THREADS);
    try {
      List<Future<?>> commanding =
          java.util.stream.IntStream.range(0, THREADS)
              .<Future<?>>mapToObj(i -> threads.submit(() -> commandOn(i)))
              .toList();
      for (int i = 1; i <= COMMANDERS; i++) {
        command(i * 1e-4, random, "-Ddfra.seed=" + seed + ", commander " + i);
      }
      over = true;
      for (Future<?> each : commanding) {
        each.get(60, TimeUnit.SECONDS);
      }
      for (int i = 0; i < THREADS; i++) {
        assertThat(refused.get(i)).as("-Ddfra.seed=%d: some came too late", seed).isPositive();
      }
    } finally {
      over = true;
      threads.shutdownNow();
      wheels.close();
    }
  }

  private void commandOn(int thread) {
    while (!over) {
      Command now = current;
      try {
        wheels.execute(now.key(), new Velocity(now.speed(), 0));
      } catch (CommandRefusedException e) {
        refused.incrementAndGet(thread);
        Thread.yield(); // until there is a new key it has nothing to race with
      }
    }
  }

  private void command(double speed, Random random, String which) throws Exception {
    wheels.commands.clear();
    CommandLease lease = wheels.acquireCommandLease(Duration.ofSeconds(30));
    current = new Command(lease.key(), speed);
    String mine = "turn " + speed + " 0.0";
    long begun = System.nanoTime();
    while (!wheels.commands.contains(mine)) {
      assertThat(System.nanoTime() - begun).as(which).isLessThan(TimeUnit.SECONDS.toNanos(20));
      Thread.yield();
    }
    end(lease, random);
    // Closing a lease does not wait for long for a command that has begun.
    awaitARefusalOfEach(which);
    awaitRest(which);
    int size = wheels.commands.size(); // any further one was executed after the end
    assertThat(wheels.commands.get(size - 1)).as(which).isEqualTo("halt");
    assertThat(wheels.driveState().velocity()).as(which).isEqualTo(Velocity.ZERO);
    for (int i = 0; i < 50; i++) {
      Thread.onSpinWait();
    }
    assertThat(wheels.commands).as(which).hasSize(size);
  }

  /** From then on no command that began with the old key is under way. */
  private void awaitARefusalOfEach(String which) {
    long begun = System.nanoTime();
    for (int i = 0; i < THREADS; i++) {
      int before = refused.get(i);
      while (refused.get(i) == before) {
        assertThat(System.nanoTime() - begun).as(which).isLessThan(TimeUnit.SECONDS.toNanos(20));
        Thread.yield();
      }
    }
  }

  private void awaitRest(String which) {
    long begun = System.nanoTime();
    while (!wheels.commands.get(wheels.commands.size() - 1).equals("halt")
        || !wheels.driveState().velocity().isZero()) {
      assertThat(System.nanoTime() - begun).as(which).isLessThan(TimeUnit.SECONDS.toNanos(20));
      Thread.yield();
    }
  }

  private void end(CommandLease lease, Random random) throws LeaseRefusedException {
    if (random.nextBoolean()) {
      lease.close();
    } else {
      assertThat(wheels.leases().revoke(wheels.leases().leases().get(0).handle())).isTrue();
    }
  }
}
