package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.SplittableRandom;
import org.dfra.agent.HelpCall;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.Parameters;
import org.dfra.geometry.GeoPosition;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.recruit.requester.RequesterMachine;
import org.dfra.recruit.requester.RequesterState;
import org.dfra.recruit.strategy.Affective;
import org.dfra.recruit.strategy.Greedy;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.junit.jupiter.api.Test;

/** What is written in an agent's parameters is what it decides by. */
class StrategyParserTest {

  private static final long SEED = 20261122;
  private static final Instant NOW = Instant.parse("2026-11-22T00:00:00Z");
  private static final Conversation FIRST = new Conversation("uav", 1);

  private static RecruitmentStrategy strategy(Map<String, String> texts) {
    return StrategyParser.of(
        Parameters.of("ugv1/agent", texts),
        BodyFixture.TRAITS,
        Duration.ofSeconds(5),
        new SplittableRandom(SEED));
  }

  private static Stimulus asked(double eta, boolean busy) {
    return new Stimulus(FIRST, Duration.ofMillis((long) (1000 * eta)), 1, busy, NOW);
  }

  @Test
  void whatIsNotWrittenIsAsItWasMeasured() {
    ShameSettings usual =
        ShameSettings.forField(BodyFixture.TRAITS.diagonal(), BodyFixture.TRAITS.speed());
    assertThat(usual).isEqualTo(new ShameSettings(1.5, 2, 0.1, 1, 0.5, usual.etaReference(), 0.2));
    Affective measured = new Affective(new Shame(usual));
    RecruitmentStrategy read = strategy(Map.of());
    assertThat(read.name()).isEqualTo("affective");
    for (double eta : new double[] {150, 120, 500}) {
      for (boolean busy : new boolean[] {true, false}) {
        boolean unused = measured.shouldOffer(asked(eta, busy));
        assertThat(read.shouldOffer(asked(eta, busy))).isFalse();
        assertThat(read.urge()).isEqualTo(measured.urge()).isPositive();
      }
    }
    RecruitmentStrategy impatient = strategy(Map.of("affect", "impatience"));
    assertThat(impatient.shouldOffer(asked(0, false))).as("5 s of 5 s").isTrue();
    impatient.onNotChosen();
    assertThat(impatient.shouldOffer(asked(1e6, false))).as("5 s of 30 s").isFalse();
    assertThat(impatient.urge()).isCloseTo(1 / 6.0, within(1e-9));
  }

  @Test
  void shameHasTheConstantsThatAreWritten() {
    RecruitmentStrategy read =
        strategy(
            Map.of(
                "shame_gain", "0.4",
                "shame_exponent", "3",
                "shame_floor", "0.25",
                "shame_idle_factor", "0.8",
                "shame_busy_factor", "0.3",
                "eta_reference", "100"));
    double urge = 0.4 * 0.8 * Math.pow(0.75, 3);
    assertThat(read.shouldOffer(asked(25, false))).isFalse();
    assertThat(read.urge()).as("idle").isCloseTo(urge, within(1e-9));
    urge += 0.4 * 0.3 * Math.pow(0.75, 3);
    assertThat(read.shouldOffer(asked(25, true))).isFalse();
    assertThat(read.urge()).as("at work").isCloseTo(urge, within(1e-9));
    urge += 0.4 * 0.8 * 0.25;
    assertThat(read.shouldOffer(asked(99, false))).isFalse();
    assertThat(read.urge()).as("the floor").isCloseTo(urge, within(1e-9));
  }

  @Test
  void impatienceHasTheNumbersThatAreWritten() {
    RecruitmentStrategy read =
        strategy(
            Map.of(
                "affect", "impatience",
                "impatience_min_wait", "10",
                "impatience_max_wait", "40",
                "eta_reference", "100"));
    assertThat(read.shouldOffer(asked(0, false))).isFalse();
    assertThat(read.urge()).as("5 s of 10 s").isCloseTo(0.5, within(1e-9));
    read.onNotChosen();
    assertThat(read.shouldOffer(asked(100, false))).isFalse();
    assertThat(read.urge()).as("5 s of 40 s").isCloseTo(0.125, within(1e-9));
  }

  @Test
  void thatByLotOffersWithTheChanceThatIsWritten() {
    int calls = 10_000;
    RecruitmentStrategy seldom =
        strategy(Map.of("strategy", "random", "random_offer_probability", "0.2"));
    int offers = 0;
    for (int i = 0; i < calls; i++) {
      offers += seldom.shouldOffer(asked(9, false)) ? 1 : 0;
    }
    // five standard deviations of 40
    assertThat(offers).as("of " + calls + " with seed " + SEED).isBetween(1800, 2200);
    RecruitmentStrategy always =
        strategy(Map.of("strategy", "random", "random_offer_probability", "1"));
    for (int i = 0; i < calls; i++) {
      assertThat(always.shouldOffer(asked(9, false))).isTrue();
    }
    RecruitmentStrategy usual = strategy(Map.of("strategy", "random"));
    SplittableRandom coin = new SplittableRandom(SEED);
    for (int i = 0; i < calls; i++) {
      assertThat(usual.shouldOffer(asked(9, false)))
          .as("draw " + i + " as it was measured")
          .isEqualTo(coin.nextBoolean());
    }
  }

  private static Duration awaited(Map<String, String> texts) {
    RecruitmentSettings settings = RecruitmentSettingsParser.of(Parameters.of("uav/agent", texts));
    RequesterMachine machine = new RequesterMachine(settings, new Greedy());
    HelpCall call =
        new HelpCall(
            "mine", new GeoPosition(48, 11, 0), Duration.ofSeconds(9), Duration.ofSeconds(99));
    RequesterState calling = machine.call(RequesterState.idle(FIRST), call, NOW).state();
    Accept offer = new Accept(calling.conversation(), 0, Duration.ofSeconds(10), 1);
    return Duration.between(NOW, machine.receive(calling, "ugv1", offer, NOW).state().due());
  }

  @Test
  void aCallerAwaitsOffersForTheConfiguredWindow() {
    assertThat(awaited(Map.of())).as("greedy's own").isEqualTo(Duration.ofSeconds(2));
    assertThat(awaited(Map.of("offer_window", "3.5"))).isEqualTo(Duration.ofMillis(3500));
    assertThatThrownBy(
            () -> awaited(Map.of("offer_window", "4", "replace_after", "5", "margin", "1")))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            "code: uav/agent: parameter offer_window is \"4\", which is not below replace_after less"
                + " margin, 4.0 s");
  }
}
