package org.dfra.river.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Subscription;
import org.dfra.flow.effector.BrakeEngagedException;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.effector.DriveState;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What every effector guarantees to its commander and to other clients, wherever it runs. */
@Timeout(60)
abstract class EffectorContract extends EmergencyStopContract {

  @Test
  void executesTheCommandsOfItsCommanderInOrder() throws Exception {
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      assertThat(lease.isLive()).isTrue();
      effector().execute(lease.key(), AHEAD);
      effector().execute(lease.key(), new Velocity(4, 4));
      effector().execute(lease.key(), new Brake(true));
      effector().execute(lease.key(), new Brake(false));
      effector().execute(lease.key(), Velocity.ZERO);
      assertThat(driver().commands)
          .containsExactly(
              TURNED, "turn 1.0 1.0", "halt", "brake true", "brake false", "turn 0.0 0.0");
      DriveState state = effector().driveState();
      assertThat(state.commander()).isEqualTo(commander());
      assertThat(state.velocity()).isEqualTo(Velocity.ZERO);
      assertThat(state.parkingBrakeEngaged()).isFalse();
    }
  }

  @Test
  void refusesWhoHoldsNoKey() throws Exception {
    CommandKey invented = new CommandKey(UUID.randomUUID());
    assertThatThrownBy(() -> effector().execute(invented, AHEAD))
        .isInstanceOf(CommandRefusedException.class)
        .hasMessage(
            PATH
                + " has no commander, and this key is not valid any more; request a command lease");
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      assertThatThrownBy(() -> effector().execute(invented, AHEAD))
          .isInstanceOf(CommandRefusedException.class)
          .hasMessageStartingWith(PATH + " is commanded by " + commander() + " since ")
          .hasMessageNotContaining(lease.key().secret().toString());
      assertThat(driver().commands).isEmpty();
    }
  }

  @Test
  void refusesASecondCommanderAndNamesTheFirst() throws Exception {
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      LeaseHandle handle = driver().leases().leases().get(0).handle();
      assertThatThrownBy(() -> effector().acquireCommandLease(LEASE))
          .isInstanceOf(LeaseRefusedException.class)
          .hasMessageStartingWith(PATH + " is commanded by " + commander() + " since ")
          .hasMessageContaining("have its lease " + handle + " revoked");
      effector().execute(lease.key(), AHEAD);
      assertThat(driver().commands).as("the first is not disturbed").containsExactly(TURNED);
    }
  }

  @Test
  void countsItsCommanderAsOne() throws Exception {
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      assertThat(driver().leases().leases())
          .singleElement()
          .extracting(LeaseStatus::role)
          .isEqualTo(LeaseRole.COMMANDER);
      assertThat(effector().readiness()).isEqualTo(Readiness.ACTIVE);
      assertThat(lease.expiration()).isAfter(java.time.Instant.now());
    }
    assertThat(effector().readiness()).isEqualTo(Readiness.READY);
    assertThat(driver().leases().leases()).isEmpty();
  }

  @Test
  void aClosedLeaseHaltsTheWheelsAndFreesTheEffectorBeforeItReturns() throws Exception {
    for (int i = 0; i < 20; i++) {
      driver().commands.clear();
      CommandLease lease = effector().acquireCommandLease(LEASE);
      effector().execute(lease.key(), AHEAD);
      lease.close();
      lease.close();
      assertThat(lease.isLive()).isFalse();
      assertThat(driver().commands).containsExactly(TURNED, "halt");
      assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
          .isInstanceOf(CommandRefusedException.class);
    }
  }

  @Test
  void aRevokedLeaseHaltsTheWheelsAndItsHolderIsNotified() throws Exception {
    CommandLease lease = effector().acquireCommandLease(LEASE);
    effector().execute(lease.key(), AHEAD);
    assertThat(driver().leases().revoke(driver().leases().leases().get(0).handle())).isTrue();
    assertThat(driver().commands).containsExactly(TURNED, "halt");
    assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
        .isInstanceOf(CommandRefusedException.class);
    await().atMost(PATIENCE).until(() -> !lease.isLive());
    try (CommandLease next = effector().acquireCommandLease(LEASE)) {
      lease.close();
      effector().execute(next.key(), AHEAD);
      assertThat(driver().commands).as("the old holder's close").endsWith("halt", TURNED);
    }
  }

  @Test
  void aModuleThatEndsHaltsTheWheelsBeforeItClosesItsDevice() throws Exception {
    CommandLease lease = effector().acquireCommandLease(LEASE);
    effector().execute(lease.key(), AHEAD);
    end();
    assertThat(driver().commands).containsExactly(TURNED, "halt", "closed");
    assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
        .isInstanceOfAny(CommandRefusedException.class, RemoteException.class);
    assertThat(driver().commands).containsExactly(TURNED, "halt", "closed");
    lease.close();
    assertThat(lease.isLive()).isFalse();
  }

  @Test
  void silenceHaltsTheWheelsAndIsCounted() throws Exception {
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      effector().execute(lease.key(), AHEAD);
      await().atMost(PATIENCE).until(this::hasFallenSilent);
      assertThat(driver().commands).containsExactly(TURNED, "halt");
      assertThat(effector().driveState().velocity()).isEqualTo(Velocity.ZERO);
      assertThat(lease.isLive()).as("it still commands").isTrue();
      effector().execute(lease.key(), AHEAD);
      assertThat(driver().commands).startsWith(TURNED, "halt", TURNED);
    }
  }

  private boolean hasFallenSilent() throws RemoteException {
    driver().look();
    return effector().driveState().commandTimeouts() == 1;
  }

  @Test
  void refusesToMoveWithItsBrakeSet() throws Exception {
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      effector().execute(lease.key(), new Brake(true));
      assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
          .isInstanceOf(BrakeEngagedException.class)
          .hasMessage(PATH + " has its brake set, and does not move until that is released");
      assertThat(driver().commands).containsExactly("halt", "brake true");
      assertThat(effector().driveState().parkingBrakeEngaged()).isTrue();
    }
  }

  @Test
  void executesNothingWhileItDoesNotServe() throws Exception {
    try (CommandLease lease = effector().acquireCommandLease(LEASE)) {
      driver().lose();
      assertThatThrownBy(() -> effector().execute(lease.key(), AHEAD))
          .isInstanceOf(NotReadyException.class)
          .hasMessageStartingWith(PATH + " is INITIALIZING: it cannot execute ");
      assertThat(driver().commands).isEmpty();
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "PT120S | lease 120 s > longest allowed 30 s; ask for 30 s or less",
        "PT0S | lease 0 s is not above 0; ask for 30 s or less",
      })
  void aRefusedLeaseLeavesTheEffectorFree(Duration asked, String sentence) throws Exception {
    assertThatThrownBy(() -> effector().acquireCommandLease(asked))
        .isInstanceOf(LeaseRefusedException.class)
        .hasMessage(PATH + ": " + sentence);
    assertThat(driver().commands).as("there was no commander to lose").isEmpty();
    effector().acquireCommandLease(LEASE).close();
  }

  @Test
  void publishesItsStateToSubscribers() throws Exception {
    List<DriveState> received = new CopyOnWriteArrayList<>();
    try (Subscription unused =
            effector()
                .subscribe(
                    delivery -> {
                      if (delivery.event() instanceof NewReading reading) {
                        received.add((DriveState) reading.reading());
                      }
                    },
                    DeliveryPolicy.keepLast(100).withKinds(EventKind.READING));
        CommandLease lease = effector().acquireCommandLease(LEASE)) {
      effector().execute(lease.key(), AHEAD);
      lease.close();
      await().atMost(PATIENCE).until(() -> received.size() >= 2);
    }
    assertThat(received.get(0).velocity()).isEqualTo(AHEAD);
    assertThat(received.get(0).commander()).isEqualTo(commander());
    assertThat(received.get(1).velocity()).isEqualTo(Velocity.ZERO);
    assertThat(received.get(1).commander()).isNull();
  }

  @Test
  void onlyOneOfManyWhoAskAtOnceCommands() throws Exception {
    for (int round = 0; round < 10; round++) {
      List<CommandLease> granted = new CopyOnWriteArrayList<>();
      List<CompletableFuture<Void>> asking =
          java.util.stream.IntStream.range(0, 8)
              .mapToObj(i -> CompletableFuture.runAsync(() -> ask(granted)))
              .toList();
      for (CompletableFuture<Void> each : asking) {
        each.get(20, TimeUnit.SECONDS);
      }
      assertThat(granted).hasSize(1);
      granted.get(0).close();
    }
  }

  private void ask(List<CommandLease> granted) {
    try {
      granted.add(effector().acquireCommandLease(LEASE));
    } catch (LeaseRefusedException e) {
      assertThat(e).hasMessageStartingWith(PATH + " is commanded by ");
    } catch (RemoteException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void noCommandOfAnOldKeyIsExecutedOnceAnotherCommands() throws Exception {
    for (int i = 1; i <= 20; i++) {
      CommandLease lease = effector().acquireCommandLease(LEASE);
      String mine = "turn " + i * 1e-3 + " 0.0";
      CompletableFuture<Void> commanding = CompletableFuture.runAsync(() -> commandOn(lease.key()));
      Velocity velocity = new Velocity(i * 1e-3, 0);
      executeAtLast(lease.key(), velocity);
      assertThat(driver().commands).contains(mine);
      lease.close();
      driver().commands.clear();
      try (CommandLease next = effector().acquireCommandLease(LEASE)) {
        executeAtLast(next.key(), AHEAD);
        commanding.get(20, TimeUnit.SECONDS);
        assertThat(driver().commands).as("of commander %d", i).containsExactly(TURNED);
      }
    }
  }

  /** A busy computer may hold up a command behind another one until it is too old; then again. */
  private void executeAtLast(CommandKey key, Velocity velocity) throws RemoteException {
    while (true) {
      try {
        effector().execute(key, velocity);
        return;
      } catch (CommandRefusedException e) {
        assertThat(e).hasMessageContaining("was held up by an earlier command");
      }
    }
  }
}
