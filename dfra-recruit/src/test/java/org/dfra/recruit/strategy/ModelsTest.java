package org.dfra.recruit.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.dfra.core.config.ConfigurationException;
import org.dfra.recruit.affect.Impatience;
import org.dfra.recruit.affect.Shame;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.affect.Stimulus;
import org.dfra.recruit.loss.LossModel;
import org.dfra.recruit.loss.LossModel.GilbertElliottLoss;
import org.dfra.recruit.loss.LossModel.IndependentLoss;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.requester.Bid;
import org.dfra.recruit.transport.DelayModel.LogNormalDelay;
import org.junit.jupiter.api.Test;

/** Strategies, affects, losses and delays by the numbers that their equations give. */
class ModelsTest {

  private static final Instant NOW = Instant.parse("2026-11-21T00:00:00Z");
  private static final ShameSettings SHAME = new ShameSettings(1.5, 2, 0.1, 1, 0.5, 100, 0.2);

  private static Stimulus asked(double eta, double battery, boolean busy, Instant when) {
    return asked(1, eta, battery, busy, when);
  }

  private static Stimulus asked(
      long conversation, double eta, double battery, boolean busy, Instant when) {
    return new Stimulus(
        new Conversation("uav", conversation),
        Duration.ofMillis((long) (1000 * eta)),
        battery,
        busy,
        when);
  }

  @Test
  void shameGrowsAsTheEquationSays() {
    Shame shame = new Shame(SHAME);
    shame.stimulate(asked(50, 1, false, NOW));
    assertThat(shame.level()).isCloseTo(1.5 * 0.25, within(1e-9));
    shame.stimulate(asked(50, 1, true, NOW));
    assertThat(shame.level()).isCloseTo(1.5 * 0.25 * 1.5, within(1e-9));
    shame.onRelease();
    shame.stimulate(asked(1000, 1, false, NOW));
    assertThat(shame.level()).as("the floor").isCloseTo(0.15, within(1e-9));
    shame.onHelping();
    shame.stimulate(asked(0, 1, false, NOW));
    assertThat(shame.isTriggered()).isTrue();
    shame.onHelping();
    shame.stimulate(asked(0, 0.2, false, NOW));
    assertThat(shame.level()).as("at the reserve").isCloseTo(0.3, within(1e-9));
  }

  @Test
  void impatienceGrowsWithTheTimeThatACallIsUnanswered() {
    Impatience impatience = new Impatience(10, 40, 100, Duration.ofSeconds(5));
    impatience.stimulate(asked(0, 1, false, NOW));
    assertThat(impatience.level()).isCloseTo(0.5, within(1e-9));
    impatience.stimulate(asked(0, 1, false, NOW.plusSeconds(5)));
    assertThat(impatience.isTriggered()).isTrue();
    impatience.onRelease();
    impatience.stimulate(asked(100, 1, false, NOW));
    assertThat(impatience.level()).isCloseTo(0.125, within(1e-9));
  }

  @Test
  void thePauseBetweenTwoCallsIsNoWaitingThoughTheEndOfTheFirstWasNotReceived() {
    Impatience impatience = new Impatience(5, 30, 100, Duration.ofSeconds(5));
    impatience.stimulate(asked(1, 100, 1, true, NOW));
    assertThat(impatience.level()).as("5 s of 60 s").isCloseTo(5 / 60.0, within(1e-9));
    Instant next = NOW.plusSeconds(600);
    impatience.stimulate(asked(2, 100, 1, true, next));
    assertThat(impatience.level()).as("5 s more").isCloseTo(10 / 60.0, within(1e-9));
    impatience.stimulate(asked(2, 100, 1, true, next.plusSeconds(15)));
    assertThat(impatience.level())
        .as("a further round, two between were lost: 15 s more")
        .isCloseTo(25 / 60.0, within(1e-9));
    Impatience restored = new Impatience(5, 30, 100, Duration.ofSeconds(5));
    restored.restore(impatience.level());
    restored.stimulate(asked(2, 100, 1, true, next.plusSeconds(500)));
    assertThat(restored.level())
        .as("its process died and does not know since when it waits")
        .isCloseTo(30 / 60.0, within(1e-9));
  }

  @Test
  void theNearestIsChosenAndAnEmptyBatteryIsFar() {
    Bid near = new Bid("near", 0, Duration.ofSeconds(10), 0.1);
    Bid far = new Bid("far", 0, Duration.ofSeconds(15), 1);
    assertThat(new Greedy().choose(List.of(near, far))).isEqualTo(far);
    assertThat(new Greedy().choose(List.of(far, new Bid("x", 0, Duration.ofSeconds(10), 1))))
        .extracting(Bid::robot)
        .isEqualTo("x");
  }

  @Test
  void anUnknownStrategyIsRefusedWithThoseThereAre() {
    assertThatThrownBy(
            () -> StrategyRegistry.named("gredy", new Shame(SHAME), new SplittableRandom(1)))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage("unknown strategy \"gredy\"; did you mean \"greedy\"?");
  }

  @Test
  void lossModelsLoseTheirShare() {
    int envelopes = 200_000;
    GilbertElliottLoss bursts = GilbertElliottLoss.bursts(0.25, 5, new SplittableRandom(3));
    assertThat(bursts.share()).isCloseTo(0.25, within(1e-9));
    // ten standard deviations: bursts of five make as much as a fifth of the messages
    assertThat(share(bursts, envelopes)).isCloseTo(0.25, within(0.02));
    assertThat(share(new IndependentLoss(0.25, new SplittableRandom(4)), envelopes))
        .isCloseTo(0.25, within(0.01));
  }

  private static double share(LossModel model, int envelopes) {
    int lost = 0;
    for (int i = 0; i < envelopes; i++) {
      lost += model.loses("a", "b") ? 1 : 0;
    }
    return (double) lost / envelopes;
  }

  @Test
  void aFitFindsTheDistributionAgain() {
    LogNormalDelay truth = new LogNormalDelay(0.001, 0.003, 0.5);
    SplittableRandom random = new SplittableRandom(5);
    double[] drawn = new double[20_000];
    Arrays.setAll(drawn, i -> truth.next(random));
    LogNormalDelay fit = LogNormalDelay.fit(drawn);
    Arrays.sort(drawn);
    double[] again = new double[drawn.length];
    Arrays.setAll(again, i -> fit.next(random));
    Arrays.sort(again);
    for (double share : new double[] {0.25, 0.5, 0.75, 0.95}) {
      int place = (int) (share * drawn.length);
      // the shortest delay is only known from the sample, which costs a few per cent elsewhere
      assertThat(again[place]).isCloseTo(drawn[place], within(0.1 * drawn[place]));
    }
  }
}
