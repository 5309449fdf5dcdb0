package org.dfra.recruit.loss;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dfra.recruit.loss.LossModel.GilbertElliottLoss;
import org.junit.jupiter.api.Test;

/** Losses in bursts against the theory of the two-state chain. */
class GilbertElliottLossTest {

  private static final long SEED = 20261121;
  private static final int MESSAGES = 400_000;

  private static SplittableRandom random() {
    return new SplittableRandom(SEED);
  }

  private static double lost(LossModel model) {
    int lost = 0;
    for (int i = 0; i < MESSAGES; i++) {
      lost += model.loses("uav", "ugv") ? 1 : 0;
    }
    return (double) lost / MESSAGES;
  }

  /**
   * The share lost of n messages has a variance of p (1 - p) / n, times (1 + r) / (1 - r) where
   * states are correlated by r = 1 - toBad - toGood from one message to the next. For the longest
   * bursts here r is below 0.95: a standard deviation of 0.0043, and four of them.
   */
  @Test
  void losesTheShareInTheLongRun() {
    for (double share : new double[] {0.1, 0.25, 0.5}) {
      for (double burst : new double[] {2, 5, 20}) {
        GilbertElliottLoss model = GilbertElliottLoss.bursts(share, burst, random());
        assertThat(model.share()).isCloseTo(share, within(1e-12));
        assertThat(lost(model))
            .as("share %s, bursts of %s, seed %s", share, burst, SEED)
            .isCloseTo(share, within(0.0175));
      }
    }
  }

  /** With loss in both states the share is that of the states: 1/5 bad, 0.2 · 0.8 + 0.8 · 0.05. */
  @Test
  void losesInBothStates() {
    GilbertElliottLoss model = new GilbertElliottLoss(0.1, 0.4, 0.05, 0.8, random());
    assertThat(model.share()).isCloseTo(0.2, within(1e-12));
    assertThat(lost(model)).as("seed %s", SEED).isCloseTo(0.2, within(0.01));
  }

  /**
   * Bursts are geometric with mean b: a standard deviation below b, so the mean of at least 5000 of
   * them is within 4 b / √5000, which is 6 %.
   */
  @Test
  void burstsHaveTheirMeanLength() {
    for (double burst : new double[] {2, 5, 20}) {
      GilbertElliottLoss model = GilbertElliottLoss.bursts(0.25, burst, random());
      int bursts = 0;
      int lost = 0;
      boolean was = false;
      for (int i = 0; i < MESSAGES; i++) {
        boolean is = model.loses("uav", "ugv");
        bursts += is && !was ? 1 : 0;
        lost += is ? 1 : 0;
        was = is;
      }
      assertThat(bursts).as("bursts of %s", burst).isGreaterThan(4_500);
      assertThat((double) lost / bursts)
          .as("bursts of %s, seed %s", burst, SEED)
          .isCloseTo(burst, within(0.06 * burst));
    }
  }

  @Test
  void eachLinkIsGoodOrBadByItself() {
    GilbertElliottLoss model = new GilbertElliottLoss(0, 1, 0, 1, random());
    GilbertElliottLoss stuck = new GilbertElliottLoss(1, 1e-9, 0, 1, random());
    assertThat(stuck.loses("a", "b")).as("it begins good").isFalse();
    assertThat(stuck.loses("a", "b")).as("and is bad from then on").isTrue();
    assertThat(stuck.loses("b", "a")).as("the way back is another link").isFalse();
    assertThat(model.loses("a", "b")).isFalse();
  }

  @Test
  void whatIsNoProbabilityIsRefused() {
    assertThatThrownBy(() -> new GilbertElliottLoss(1.2, 0.5, 0, 1, random()))
        .hasMessage("probability 1.2 is outside 0 to 1");
    assertThatThrownBy(() -> new GilbertElliottLoss(0.5, 0, 0, 1, random()))
        .hasMessageContaining("never become good again");
    assertThatThrownBy(() -> GilbertElliottLoss.bursts(1, 5, random()))
        .hasMessage(
            "a loss of 1.0 in bursts of 5.0 messages is impossible; give a share of 0 to less than"
                + " 1, and bursts of 1 or more");
  }
}
