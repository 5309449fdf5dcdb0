package org.dfra.recruit.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.dfra.core.config.ConfigurationException;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.requester.Bid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Strategies by name, those of a user among them. */
class StrategyRegistryTest {

  private static final String HERE = StrategyRegistryTest.class.getName() + "$";

  /** A user's, as small as can be. */
  public static class Modest implements RecruitmentStrategy {
    @Override
    public String name() {
      return "modest";
    }

    @Override
    public boolean shouldOffer(Stimulus stimulus) {
      return !stimulus.busy();
    }

    @Override
    public Bid choose(List<Bid> bids) {
      return bids.get(bids.size() - 1);
    }
  }

  /** A user's, by chance. */
  public static final class Chancy extends Modest {
    private final RandomGenerator random;

    public Chancy(RandomGenerator random) {
      this.random = random;
    }

    @Override
    public boolean shouldOffer(Stimulus stimulus) {
      return random.nextBoolean();
    }
  }

  /** Cannot be made from a name. */
  public static final class Demanding extends Modest {
    public Demanding(String ofThem) {
      assertThat(ofThem).isNotNull();
    }
  }

  /** Throws when it is made. */
  public static final class Broken extends Modest {
    public Broken() {
      throw new IllegalStateException("no file with my habits");
    }
  }

  private static RecruitmentStrategy named(String name) {
    return StrategyRegistry.named(
        name, new Shame(ShameSettings.forField(100, 1)), new SplittableRandom(20261122));
  }

  private static Stimulus asked(boolean busy) {
    return new Stimulus(new Conversation("uav", 1), Duration.ofSeconds(9), 1, busy, Instant.EPOCH);
  }

  @ParameterizedTest
  @ValueSource(strings = {"affective", "greedy", "random", "contract-net"})
  void knowsThoseOfTheProject(String name) {
    assertThat(named(name).name()).isEqualTo(name);
    assertThat(StrategyRegistry.NAMES).contains(name);
  }

  @Test
  void makesAUsersByItsClass() {
    RecruitmentStrategy modest = named(HERE + "Modest");
    assertThat(modest).isInstanceOf(Modest.class);
    assertThat(modest.shouldOffer(asked(false))).isTrue();
    assertThat(modest.shouldOffer(asked(true))).isFalse();
    assertThat(modest.offerWindow()).isEqualTo(Duration.ofSeconds(2));
    assertThat(modest.urge()).isZero();
    assertThat(modest.sendsRefusal()).isFalse();
    assertThat(modest.notifiesIndividually()).isFalse();
  }

  @Test
  void givesAUsersItsChance() {
    RecruitmentStrategy one = named(HERE + "Chancy");
    RecruitmentStrategy again = named(HERE + "Chancy");
    for (int i = 0; i < 100; i++) {
      assertThat(one.shouldOffer(asked(false))).isEqualTo(again.shouldOffer(asked(false)));
    }
  }

  private static void refused(String name, String sentence) {
    assertThatThrownBy(() -> named(name))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(sentence);
  }

  @Test
  void refusesWhatIsNone() {
    refused(
        "brave",
        "unknown strategy \"brave\"; use affective, greedy, random, contract-net, or"
            + " a class by its full name");
    refused(
        "org.example.Nobody",
        "strategy class org.example.Nobody is not on the class path; add its jar or correct the"
            + " name");
    refused(
        "java.lang.String",
        "strategy class java.lang.String does not implement"
            + " org.dfra.recruit.strategy.RecruitmentStrategy");
    refused(
        HERE + "Demanding",
        "strategy class "
            + HERE
            + "Demanding has no public constructor () or (RandomGenerator); add one");
    refused(
        HERE + "Broken",
        "strategy class "
            + HERE
            + "Broken cannot be instantiated: java.lang.IllegalStateException: no file with my habits");
  }
}
