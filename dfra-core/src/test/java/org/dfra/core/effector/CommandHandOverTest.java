package org.dfra.core.effector;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * The command of an effector is handed over, expires, is revoked, and survives no crash, in random
 * interleavings: never do two clients hold it.
 *
 * <p>{@code dfra.full}: 10 000 interleavings; {@code dfra.soak}: 100 000.
 */
class CommandHandOverTest {

  private static final int WORLDS =
      Boolean.getBoolean("dfra.soak") ? 100_000 : Boolean.getBoolean("dfra.full") ? 10_000 : 500;

  private static final int STEPS = 60;

  @Test
  @Timeout(value = 1, unit = TimeUnit.HOURS)
  void neverTwoHoldersHoweverHandOverCrashAndExpiryInterleave() {
    long first = Long.getLong("dfra.seed", 18);
    int commands = 0;
    int refusals = 0;
    int handOvers = 0;
    for (int i = 0; i < WORLDS; i++) {
      HandOverWorld world =
          new HandOverWorld(first + i, "-Ddfra.seed=" + first + ", interleaving " + i);
      world.play(STEPS);
      commands += world.commands();
      refusals += world.refusals();
      handOvers += world.handOvers();
    }
    System.out.printf(
        "%d interleavings: %d hand-overs, %d commands executed, %d refused, never two holders%n",
        WORLDS, handOvers, commands, refusals);
    assertThat(handOvers).isGreaterThan(WORLDS);
    assertThat(commands).isGreaterThan(WORLDS);
    assertThat(refusals).isGreaterThan(WORLDS);
  }
}
