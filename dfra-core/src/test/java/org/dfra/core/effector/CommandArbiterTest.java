package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandRefusedByEmergencyStopException;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.LeaseRefusedByEmergencyStopException;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.slf4j.LoggerFactory;

class CommandArbiterTest {

  private static final UUID LEASE = new UUID(1, 2);

  private final List<String> reported = new ArrayList<>();
  private final List<UUID> revoked = new ArrayList<>();
  private final InstantSource clock = InstantSource.fixed(Instant.EPOCH);
  private final EmergencyStopLatch stop =
      new EmergencyStopLatch(
          "atrv1/wheels",
          StateStore.inMemory(),
          clock,
          Scheduler.system(),
          BootId.system(),
          LoggerFactory.getLogger("dfra.atrv1.wheels"));
  private final CommandArbiter arbiter =
      new CommandArbiter(
          "atrv1/wheels",
          clock,
          () -> reported.add("lost"),
          () -> {},
          Runnable::run,
          stop,
          revoked::add);
  private Runnable over = () -> {};

  private CommandKey take(String name) throws LeaseRefusedException {
    return arbiter.acquire(
        name,
        whenOver -> {
          over = whenOver;
          return LEASE;
        });
  }

  @Test
  void executesCommandsOfItsCommanderAndOfNobodyElse() throws Exception {
    CommandKey stranger = new CommandKey(UUID.randomUUID());
    assertThatThrownBy(() -> arbiter.execute(stranger, () -> reported.add("done")))
        .isInstanceOf(CommandRefusedException.class)
        .hasMessage(
            "atrv1/wheels has no commander, and this key is not valid any more; request a command"
                + " lease");
    CommandKey key = take("a client at 192.0.2.7");
    assertThat(arbiter.isHeldBy(key)).isTrue();
    assertThat(arbiter.commander()).isEqualTo("a client at 192.0.2.7");
    arbiter.execute(key, () -> reported.add("done"));
    arbiter.execute(new CommandKey(key.secret()), () -> reported.add("by a copy of the key"));
    assertThatThrownBy(() -> arbiter.execute(stranger, () -> reported.add("done")))
        .isInstanceOf(CommandRefusedException.class)
        .hasMessage(
            "atrv1/wheels is commanded by a client at 192.0.2.7 since 1970-01-01T00:00:00Z; this"
                + " key is not, or no longer, its commander's");
    assertThat(reported).containsExactly("done", "by a copy of the key");
  }

  @Test
  void refusesASecondCommanderAndNamesTheFirstAndItsLease() throws Exception {
    CommandKey first = take("a client at 192.0.2.7");
    assertThatThrownBy(() -> take("another"))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage(
            "atrv1/wheels is commanded by a client at 192.0.2.7 since 1970-01-01T00:00:00Z; wait"
                + " until it releases its lease, or have its lease "
                + LeaseHandle.of(LEASE)
                + " revoked");
    assertThat(arbiter.isHeldBy(first)).isTrue();
  }

  @Test
  void anEndedLeaseIsReportedOnceAndDoesNotEndTheNext() throws Exception {
    CommandKey first = take("the first");
    Runnable firstOver = over;
    firstOver.run();
    firstOver.run();
    assertThat(reported).containsExactly("lost");
    CommandKey second = take("the second");
    firstOver.run();
    assertThat(arbiter.isHeldBy(second)).as("a late end of the first").isTrue();
    assertThatThrownBy(() -> arbiter.execute(first, () -> reported.add("done")))
        .hasMessageContaining("is commanded by the second");
    assertThat(reported).containsExactly("lost");
  }

  @Test
  void aLeaseThatIsNotGrantedLeavesTheEffectorFreeAndHaltsNothing() throws Exception {
    assertThatThrownBy(
            () ->
                arbiter.acquire(
                    "too greedy",
                    whenOver -> {
                      throw new LeaseRefusedException("too long");
                    }))
        .hasMessage("too long");
    assertThatThrownBy(
            () ->
                arbiter.acquire(
                    "unlucky",
                    whenOver -> {
                      throw new OutOfMemoryError("a scripted one");
                    }))
        .isInstanceOf(OutOfMemoryError.class);
    assertThat(arbiter.commander()).isNull();
    assertThat(reported).isEmpty();
    assertThat(arbiter.isHeldBy(take("the next"))).isTrue();
  }

  @Test
  void aLeaseThatIsOverBeforeItIsHandedOutComesWithAKeyThatDoesNotCount() throws Exception {
    CommandKey key =
        arbiter.acquire(
            "short-lived",
            whenOver -> {
              whenOver.run();
              return LEASE;
            });
    assertThat(reported).containsExactly("lost");
    assertThat(arbiter.isHeldBy(key)).isFalse();
    assertThatThrownBy(() -> arbiter.execute(key, () -> reported.add("done")))
        .isInstanceOf(CommandRefusedException.class);
    CommandKey next = take("the next");
    assertThatThrownBy(() -> take("another"))
        .as("no trace of the first lease")
        .hasMessageContaining("by the next")
        .hasMessageContaining(LeaseHandle.of(LEASE).toString())
        .hasMessageNotContaining(LEASE.toString());
    assertThat(arbiter.isHeldBy(next)).isTrue();
  }

  @Test
  void aCommandThatFailsLeavesTheCommander() throws Exception {
    CommandKey key = take("a client");
    assertThatThrownBy(
            () ->
                arbiter.execute(
                    key,
                    () -> {
                      throw new IllegalArgumentException("cannot fly");
                    }))
        .hasMessage("cannot fly");
    assertThat(arbiter.isHeldBy(key)).isTrue();
  }

  @Test
  void revealsTheSecretToNobody() throws Exception {
    CommandKey key = take("a client");
    assertThat(key.toString()).doesNotContain(key.secret().toString());
    assertThatThrownBy(() -> take("another")).hasMessageNotContaining(key.secret().toString());
  }

  private static final String REFUSAL =
      "atrv1/wheels is stopped for an emergency since 1970-01-01T00:00:00Z, by ops, and executes"
          + " no commands; when it is safe, release it: ./dfra stop --release atrv1";

  @Test
  void executesNothingWhileItIsStopped() throws Exception {
    CommandKey key = take("a client");
    assertThat(stop.engage("ops")).isTrue();
    assertThatThrownBy(() -> arbiter.execute(key, () -> reported.add("done")))
        .isInstanceOf(CommandRefusedByEmergencyStopException.class)
        .hasMessage(REFUSAL);
    assertThat(arbiter.revokeCommander()).isEqualTo(LEASE);
    assertThat(arbiter.commander()).isNull();
    assertThatThrownBy(() -> take("another"))
        .isInstanceOf(LeaseRefusedByEmergencyStopException.class)
        .hasMessage(REFUSAL);
    assertThat(stop.release("ops")).isTrue();
    assertThatThrownBy(() -> arbiter.execute(key, () -> reported.add("done")))
        .as("an old key does not come back")
        .hasMessageContaining("was stopped for an emergency while this key commanded it");
    CommandKey next = take("the next");
    over.run();
    assertThat(reported).as("of the next one's end only").containsExactly("lost");
    assertThat(arbiter.isHeldBy(next)).isFalse();
  }

  /** As where the driver has stopped, and now executes the next commander's command. */
  @Test
  void aCommandIsNotCalledOffForARestThatIsNotOwedAnyMore() throws Exception {
    List<String> struck = new CopyOnWriteArrayList<>();
    List<Runnable> halts = new ArrayList<>();
    CommandArbiter late =
        new CommandArbiter(
            "atrv1/wheels",
            clock,
            () -> {},
            () -> struck.add("held up"),
            halts::add,
            stop,
            revoked::add);
    CommandKey key =
        late.acquire(
            "the first",
            whenOver -> {
              over = whenOver;
              return LEASE;
            });
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch release = new CountDownLatch(1);
    Thread commander =
        new Thread(
            () ->
                late.execute(
                    key,
                    () -> {
                      begun.countDown();
                      awaitQuietly(release);
                    }));
    commander.start();
    begun.await();
    over.run();
    assertThat(halts).hasSize(1);
    Thread halting = new Thread(halts.get(0));
    late.markStopped();
    halting.start();
    await()
        .atMost(Duration.ofSeconds(20))
        .until(() -> !struck.isEmpty() || halting.getState() == Thread.State.WAITING);
    release.countDown();
    halting.join();
    commander.join();
    assertThat(struck).isEmpty();
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void restsAtTheEndThoughWhoGivesTheCommandUpHasNotReachedThat() throws Exception {
    CommandKey key = take("a client");
    arbiter.close();
    arbiter.stopIfDue();
    assertThat(reported).containsExactly("lost");
    assertThat(arbiter.isHeldBy(key)).isFalse();
    over.run();
    arbiter.close();
    arbiter.stopIfDue();
    assertThat(reported).as("once").containsExactly("lost");
  }

  @Test
  void aCommanderThatIsRevokedWhileItsLeaseIsGrantedHasNoneAfterwards() {
    assertThatThrownBy(
            () ->
                arbiter.acquire(
                    "unlucky",
                    whenOver -> {
                      stop.engage("ops");
                      assertThat(arbiter.revokeCommander()).as("not granted yet").isNull();
                      return LEASE;
                    }))
        .isInstanceOf(LeaseRefusedByEmergencyStopException.class)
        .hasMessage(REFUSAL);
    assertThat(revoked).containsExactly(LEASE);
    assertThat(arbiter.commander()).isNull();
  }
}
