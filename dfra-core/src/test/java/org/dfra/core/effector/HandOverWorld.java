package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.UUID;
import org.dfra.core.lease.LeaseRegistry;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.lease.SteppedScheduler;
import org.dfra.core.state.StateStore;
import org.dfra.core.time.BootId;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.lease.LeaseRefusedException;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.jspecify.annotations.Nullable;
import org.slf4j.helpers.NOPLogger;

/**
 * An effector's arbiter and lease registry, clients that take the command from each other, an
 * operator, and a device, in steps that a seed chooses. One thread plays all of them: wherever the
 * arbiter calls out, it may be preempted, and the steps of others come in between. While the device
 * is commanded or stopped, these are only steps that do not wait for it.
 */
final class HandOverWorld {

  private static final Duration LONGEST = Duration.ofSeconds(9);
  private static final Duration[] DURATIONS = {Duration.ofSeconds(1), Duration.ofSeconds(3)};
  private static final int CLIENTS = 3;
  private static final int MAX_DEPTH = 3;
  private static final BootId BOOT = BootId.system();

  private final Random random;
  private final String which;
  private final SteppedScheduler time = new SteppedScheduler();
  private final InstantSource clock = InstantSource.fixed(Instant.EPOCH);
  private final StateStore store = StateStore.inMemory(); // what survives a crash
  private final List<Client> clients = new ArrayList<>();
  private final Set<CommandKey> over = new HashSet<>(); // keys whose end has returned to somebody

  /** What other threads have been given and have not begun. */
  private final List<Runnable> pending = new ArrayList<>();

  private LeaseRegistry registry;
  private CommandArbiter arbiter;
  private EmergencyStopLatch latch;
  private int depth;
  private boolean isSettling; // nobody begins anything any more
  private boolean isActing; // a command or a stop is in progress
  private @Nullable CommandKey moving; // whose command moves the device
  private int commands;
  private int refusals;
  private int handOvers;

  /** A client, and what it holds as far as it knows. */
  private static final class Client {
    final int number;
    @Nullable CommandKey key;
    @Nullable UUID lease;

    Client(int number) {
      this.number = number;
    }
  }

  HandOverWorld(long seed, String which) {
    this.random = new Random(seed);
    this.which = which;
    for (int i = 0; i < CLIENTS; i++) {
      clients.add(new Client(i));
    }
    begin();
  }

  /** Starts the effector's process, which knows nothing of the leases of the one before. */
  private void begin() {
    latch = new EmergencyStopLatch("atrv1/wheels", store, clock, time, BOOT, NOPLogger.NOP_LOGGER);
    registry =
        new LeaseRegistry(
            "atrv1/wheels",
            new LeaseTerms(LONGEST, DURATIONS[0]),
            clock,
            time,
            count -> {},
            holder -> pending::add);
    arbiter =
        new CommandArbiter(
            "atrv1/wheels",
            clock,
            this::deviceStops,
            () -> {},
            pending::add,
            latch,
            lease -> {
              preempted();
              boolean unused = registry.revoke(lease);
            });
  }

  /** Takes steps, and checks after each that at most one holds the command. */
  void play(int steps) {
    for (int i = 0; i < steps; i++) {
      step();
      check();
    }
    settle();
  }

  /** How many commands were executed. */
  int commands() {
    return commands;
  }

  /** How many were refused. */
  int refusals() {
    return refusals;
  }

  /** How often a client has become the commander. */
  int handOvers() {
    return handOvers;
  }

  private void step() {
    Client client = clients.get(random.nextInt(CLIENTS));
    switch (random.nextInt(14)) {
      case 0, 1, 2 -> acquire(client);
      case 3, 4 -> command(client);
      case 5 -> clients.stream().filter(this::isHolder).findAny().ifPresent(this::command);
      case 6 -> renew(client);
      case 7 -> cancel(client);
      case 8 -> client.lease = null; // it crashes, or is out of reach, and renews nothing
      case 9 -> time.step(Duration.ofMillis(random.nextInt(2500)));
      case 10 -> revoke();
      case 11 -> stopOrRelease();
      case 12 -> crashSeldom();
      default -> runPending();
    }
  }

  /** Where another thread may come in between. */
  private void preempted() {
    if (depth >= MAX_DEPTH || isSettling) {
      return;
    }
    depth++;
    for (int n = random.nextInt(3); n > 0; n--) {
      step();
    }
    depth--;
  }

  private void acquire(Client client) {
    CommandArbiter asked = arbiter;
    LeaseRegistry granting = registry;
    boolean isStopped = latch.isLatched();
    UUID[] lease = new UUID[1];
    CommandKey key;
    try {
      key =
          asked.acquire(
              "client " + client.number,
              onEnd -> {
                preempted();
                Duration duration = DURATIONS[random.nextInt(DURATIONS.length)];
                lease[0] = granting.grant(duration, LeaseRole.COMMANDER, null, onEnd, onEnd).id();
                preempted();
                return lease[0];
              });
    } catch (LeaseRefusedException e) {
      return;
    }
    if (asked != arbiter) {
      return; // its process has ended meanwhile: the answer never arrives
    }
    assertThat(isStopped).as("%s: a lease while it is stopped", which).isFalse();
    client.key = key;
    client.lease = lease[0];
    if (asked.isHeldBy(key)) {
      handOvers++;
      clients.stream()
          .filter(each -> each != client && each.key != null)
          .forEach(each -> over.add(each.key)); // its holder knows that no other is
    }
  }

  private boolean isHolder(Client client) {
    return client.key != null && arbiter.isHeldBy(client.key);
  }

  private void command(Client client) {
    CommandKey key = client.key;
    if (key == null || isActing) {
      return; // it would wait for the device
    }
    boolean isOver = over.contains(key);
    CommandArbiter asked = arbiter;
    try {
      asked.execute(key, () -> deviceMoves(key, asked, isOver));
    } catch (CommandRefusedException e) {
      refusals++;
    } finally {
      isActing = false;
    }
  }

  private void deviceMoves(CommandKey key, CommandArbiter asked, boolean isOver) {
    assertThat(isOver).as("%s: a command with a key that was over before", which).isFalse();
    assertThat(asked.isHeldBy(key)).as("%s: it holds the command", which).isTrue();
    assertThat(moving == null || moving.equals(key)).as("%s: nobody else moves it", which).isTrue();
    commands++;
    moving = key;
    isActing = true;
    preempted();
    isActing = false;
  }

  private void deviceStops() {
    boolean before = isActing;
    moving = null;
    isActing = true;
    preempted();
    isActing = before;
  }

  private void renew(Client client) {
    if (client.lease != null) {
      try {
        boolean unused = registry.renew(client.lease, DURATIONS[0]).isPresent();
      } catch (LeaseRefusedException e) {
        throw new AssertionError(which, e);
      }
    }
  }

  private void cancel(Client client) {
    if (client.lease != null) {
      CommandKey key = client.key;
      boolean unused = registry.cancel(client.lease);
      over.add(key);
    }
  }

  private void revoke() {
    List<LeaseStatus> leases = registry.leases();
    if (!leases.isEmpty()) {
      boolean unused = registry.revoke(leases.get(0).handle());
      clients.stream()
          .filter(each -> each.lease != null && !registry.contains(each.lease))
          .forEach(each -> over.add(each.key));
    }
  }

  private void stopOrRelease() {
    if (latch.isLatched()) {
      boolean unused = latch.release("operator");
      boolean unusedToo = latch.persist();
      return;
    }
    if (random.nextBoolean()) {
      return; // it moves more often than it is stopped
    }
    boolean unused = latch.engage("operator");
    UUID lease = arbiter.revokeCommander();
    assertThat(arbiter.commander()).as("%s: commander after a stop", which).isNull();
    clients.stream().filter(each -> each.key != null).forEach(each -> over.add(each.key));
    boolean unusedToo = latch.persist();
    if (lease != null) {
      boolean unusedThree = registry.revoke(lease);
    }
    arbiter.stopIfDue();
  }

  /** Only between the steps of others: a process that ends takes all its threads with it. */
  private void crashSeldom() {
    if (depth > 0 || random.nextInt(3) > 0) {
      return;
    }
    clients.stream().filter(each -> each.key != null).forEach(each -> over.add(each.key));
    pending.clear();
    moving = null; // the controller stops the device that gets no more commands
    begin();
  }

  private void runPending() {
    if (!pending.isEmpty() && !isActing) { // they may wait for the device
      pending.remove(random.nextInt(pending.size())).run();
    }
  }

  private void check() {
    CommandArbiter now = arbiter;
    assertThat(
            clients.stream()
                .filter(each -> each.key != null && now.isHeldBy(each.key))
                .map(each -> each.key)
                .distinct()
                .count())
        .as("%s: holders", which)
        .isLessThanOrEqualTo(1);
    assertThat(registry.clients()).as("%s: commanders' leases", which).isLessThanOrEqualTo(1);
  }

  /** All threads come to rest: who commands has the only lease, and without one nothing moves. */
  private void settle() {
    isSettling = true;
    while (!pending.isEmpty()) {
      pending.remove(0).run();
    }
    check();
    long leases = registry.leases().size();
    if (arbiter.commander() == null) {
      assertThat(leases).as("%s: leases without a commander", which).isZero();
      assertThat(moving).as("%s: moves without a commander", which).isNull();
    } else {
      assertThat(leases).as("%s: leases of the commander", which).isOne();
      time.step(LONGEST.plusSeconds(1));
      while (!pending.isEmpty()) {
        pending.remove(0).run();
      }
      assertThat(arbiter.commander()).as("%s: commander when all has expired", which).isNull();
      assertThat(moving).as("%s: moves when all has expired", which).isNull();
    }
  }
}
