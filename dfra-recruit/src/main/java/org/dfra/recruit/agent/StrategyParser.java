package org.dfra.recruit.agent;

import java.time.Duration;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.recruit.affect.Affect;
import org.dfra.recruit.affect.Impatience;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.strategy.RandomPick;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.strategy.StrategyRegistry;

/**
 * Reads an agent's strategy from its parameters. It reads those of every strategy, whichever is
 * chosen: an unread parameter is rejected as unknown.
 */
final class StrategyParser {

  private static final Duration FASTEST = Duration.ofSeconds(5);
  private static final Duration SLOWEST = Duration.ofSeconds(30);
  private static final Duration SHORTEST = Duration.ofMillis(100);
  private static final Duration LONGEST = Duration.ofHours(1);
  private static final Duration FARTHEST = Duration.ofDays(1);

  private final Parameters settings;

  private StrategyParser(Parameters settings) {
    this.settings = settings;
  }

  /**
   * The strategy with its affect; with DFRA's defaults for parameters not set.
   *
   * @param first waiting time for which the first call of a conversation counts
   * @param random of random strategies
   * @throws ConfigurationException naming the invalid parameter and its place
   */
  static RecruitmentStrategy of(
      Parameters settings, RobotTraits traits, Duration first, RandomGenerator random) {
    StrategyParser read = new StrategyParser(settings);
    Affect affect = read.affect(traits, first); // its faults are not the strategy's
    double chance =
        settings.number("random_offer_probability", RandomPick.DEFAULT_OFFER_PROBABILITY, 0.01, 1);
    String name = settings.find("strategy").orElse("affective").strip();
    try {
      return StrategyRegistry.named(name, affect, random, chance);
    } catch (ConfigurationException e) {
      throw settings.fault("strategy", "a strategy: " + e.getMessage(), e);
    }
  }

  private Affect affect(RobotTraits traits, Duration first) {
    ShameSettings shame = shame(ShameSettings.forField(traits.diagonal(), traits.speed()));
    Impatience impatience = impatience(shame.etaReference(), first);
    String name = settings.find("affect").orElse("shame").strip();
    return switch (name) {
      case "shame" -> new Shame(shame);
      case "impatience" -> impatience;
      default -> throw settings.fault("affect", "shame or impatience", null);
    };
  }

  private ShameSettings shame(ShameSettings usual) {
    return new ShameSettings(
        settings.number("shame_gain", usual.gain(), 0.01, 100),
        settings.number("shame_exponent", usual.exponent(), 0.01, 10),
        settings.number("shame_floor", usual.floor(), 0.001, 1),
        settings.number("shame_idle_factor", usual.idleFactor(), 0.01, 10),
        settings.number("shame_busy_factor", usual.busyFactor(), 0.01, 10),
        settings.find("eta_reference").isPresent()
            ? inSeconds(settings.seconds("eta_reference", FARTHEST, SHORTEST, FARTHEST))
            : usual.etaReference(),
        usual.batteryReserve());
  }

  private Impatience impatience(double etaReference, Duration first) {
    Duration fastest = settings.seconds("impatience_min_wait", FASTEST, SHORTEST, LONGEST);
    Duration slowest = settings.seconds("impatience_max_wait", SLOWEST, SHORTEST, LONGEST);
    if (slowest.compareTo(fastest) < 0) {
      throw nearOnesAreSlower(fastest, slowest);
    }
    return new Impatience(inSeconds(fastest), inSeconds(slowest), etaReference, first);
  }

  /** At least one of the two is set, since the defaults are consistent. */
  private ConfigurationException nearOnesAreSlower(Duration fastest, Duration slowest) {
    Optional<String> written = settings.find("impatience_max_wait");
    return written.isPresent()
        ? settings.fault(
            "impatience_max_wait",
            "at least impatience_min_wait, " + inSeconds(fastest) + " s",
            null)
        : settings.fault(
            "impatience_min_wait",
            "at most impatience_max_wait, " + inSeconds(slowest) + " s",
            null);
  }

  private static double inSeconds(Duration span) {
    return span.toNanos() / 1e9;
  }
}
