package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.Stream;
import org.assertj.core.data.Offset;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.BayesCombination;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.DempsterShaferCombination;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.Evidence;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.Opinion;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.DetectorRates;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class EvidenceCombinationTest {

  private static final Offset<Double> EXACT = within(1e-12);
  private static final double PRIOR = 0.1;
  private static final DetectorRates HEAT = new DetectorRates(0.8, 0.1, 1);
  private static final DetectorRates LIGHT = new DetectorRates(0.6, 0.2, 1);

  static Stream<EvidenceCombination> fusions() {
    return Stream.of(new BayesCombination(PRIOR), new DempsterShaferCombination(PRIOR));
  }

  private static Opinion both(EvidenceCombination fusion, Opinion one, Opinion other) {
    return fusion.combine(one, other).opinion();
  }

  private static void assertClose(Opinion one, Opinion other, String what) {
    assertThat(one.mine()).as(what).isCloseTo(other.mine(), EXACT);
    assertThat(one.clear()).as(what).isCloseTo(other.clear(), EXACT);
    assertThat(one.unknown()).as(what).isCloseTo(other.unknown(), EXACT);
  }

  @Test
  void bayesByHand() {
    EvidenceCombination bayes = new BayesCombination(PRIOR);
    Opinion alarms = both(bayes, bayes.opinionOf(HEAT.alarm()), bayes.opinionOf(LIGHT.alarm()));
    // 0.1·0.8·0.6 = 0.048; 0.9·0.1·0.2 = 0.018; 48/66
    assertThat(bayes.probability(alarms)).isCloseTo(48.0 / 66, EXACT);
    Opinion mixed = both(bayes, bayes.opinionOf(HEAT.alarm()), bayes.opinionOf(LIGHT.noAlarm()));
    // 0.1·0.8·0.4 = 0.032; 0.9·0.1·0.8 = 0.072; 32/104
    assertThat(bayes.probability(mixed)).isCloseTo(32.0 / 104, EXACT);
  }

  @Test
  void dempsterByHand() {
    EvidenceCombination dempster = new DempsterShaferCombination(PRIOR);
    // Alarm of heat: 1 − 0.1/0.8 = 7/8 mine. Silence of light: 1 − 0.4/0.8 = 1/2 clear.
    Opinion heat = dempster.opinionOf(HEAT.alarm());
    Opinion light = dempster.opinionOf(LIGHT.noAlarm());
    assertClose(heat, new Opinion(7.0 / 8, 0, 1.0 / 8), "heat");
    assertClose(light, new Opinion(0, 1.0 / 2, 1.0 / 2), "light");
    EvidenceCombination.Combined combined = dempster.combine(heat, light);
    // Conflict 7/8·1/2 = 7/16; left 9/16: mine 7/16, clear 1/16, unknown 1/16.
    assertThat(combined.conflict()).isCloseTo(7.0 / 16, EXACT);
    assertClose(combined.opinion(), new Opinion(7.0 / 9, 1.0 / 9, 1.0 / 9), "both");
    assertThat(dempster.probability(combined.opinion())).isCloseTo(7.1 / 9, EXACT);
  }

  @Test
  void twoWhoAreNearlyCertainOfOppositesConflict() {
    // Zadeh's case cut down to two: 0.99 against 0.99.
    EvidenceCombination dempster = new DempsterShaferCombination(PRIOR);
    EvidenceCombination.Combined combined =
        dempster.combine(new Opinion(0.99, 0, 0.01), new Opinion(0, 0.99, 0.01));
    assertThat(combined.conflict()).isCloseTo(0.9801, EXACT);
    assertThat(combined.opinion().mine()).isCloseTo(0.0099 / 0.0199, EXACT);
  }

  @ParameterizedTest
  @MethodSource("fusions")
  void orderAndGroupingChangeNothingNorDoesNothing(EvidenceCombination fusion) {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    for (int i = 0; i < 1000; i++) {
      String what = "-Ddfra.seed=" + seed + ", round " + i;
      Opinion a = fusion.opinionOf(evidence(random, random.nextDouble()));
      Opinion b = fusion.opinionOf(evidence(random, random.nextDouble()));
      Opinion c = fusion.opinionOf(evidence(random, 1));
      assertClose(both(fusion, a, b), both(fusion, b, a), what);
      assertClose(both(fusion, a, both(fusion, b, c)), both(fusion, both(fusion, a, b), c), what);
      assertClose(both(fusion, a, fusion.uninformed()), a, what);
      assertClose(both(fusion, a, fusion.opinionOf(evidence(random, 0))), a, what);
      assertThat(fusion.probability(both(fusion, a, b))).as(what).isBetween(0.0, 1.0);
    }
  }

  private static Evidence evidence(Random random, double trust) {
    return new Evidence(0.01 + random.nextDouble(), 0.01 + random.nextDouble(), trust);
  }

  @ParameterizedTest
  @MethodSource("fusions")
  void noLookLeavesThePrior(EvidenceCombination fusion) {
    assertThat(fusion.probability(fusion.uninformed())).isCloseTo(PRIOR, EXACT);
  }

  @ParameterizedTest
  @MethodSource("fusions")
  void anAlarmMakesAMineLikelierAndSilenceLess(EvidenceCombination fusion) {
    assertThat(fusion.probability(fusion.opinionOf(HEAT.alarm()))).isGreaterThan(PRIOR);
    assertThat(fusion.probability(fusion.opinionOf(HEAT.noAlarm()))).isLessThan(PRIOR);
  }

  @ParameterizedTest
  @MethodSource("fusions")
  void whollyContradictoryOpinionsLeaveNothing(EvidenceCombination fusion) {
    EvidenceCombination.Combined combined =
        fusion.combine(new Opinion(1, 0, 0), new Opinion(0, 1, 0));
    assertThat(combined.conflict()).isEqualTo(1);
    assertThat(combined.opinion()).isEqualTo(fusion.uninformed());
  }

  @Test
  void dempsterWithThePriorForAnOpinionIsBayes() {
    long seed = Long.getLong("dfra.seed", new Random().nextLong());
    Random random = new Random(seed);
    EvidenceCombination bayes = new BayesCombination(PRIOR);
    EvidenceCombination dempster = new DempsterShaferCombination(PRIOR);
    for (int round = 0; round < 200; round++) {
      Opinion likelihoods = bayes.uninformed();
      Opinion masses = new Opinion(PRIOR, 1 - PRIOR, 0);
      for (int look = 0; look < 5; look++) {
        Evidence evidence = evidence(random, 1);
        likelihoods = both(bayes, likelihoods, bayes.opinionOf(evidence));
        masses = both(dempster, masses, dempster.opinionOf(evidence));
      }
      assertThat(dempster.probability(masses))
          .as("-Ddfra.seed=%d, round %d", seed, round)
          .isCloseTo(bayes.probability(likelihoods), within(1e-9));
    }
  }

  @Test
  void bothBecomeCertainAlike() {
    EvidenceCombination bayes = new BayesCombination(PRIOR);
    EvidenceCombination dempster = new DempsterShaferCombination(PRIOR);
    Opinion likelihoods = bayes.uninformed();
    Opinion masses = dempster.uninformed();
    for (int look = 0; look < 20; look++) {
      Evidence evidence = look % 4 == 0 ? LIGHT.noAlarm() : HEAT.alarm();
      likelihoods = both(bayes, likelihoods, bayes.opinionOf(evidence));
      masses = both(dempster, masses, dempster.opinionOf(evidence));
    }
    assertThat(bayes.probability(likelihoods)).isCloseTo(1, within(1e-6));
    assertThat(dempster.probability(masses))
        .isCloseTo(bayes.probability(likelihoods), within(1e-6));
  }

  @Test
  void refusesCertainty() {
    assertThatThrownBy(() -> new BayesCombination(1)).hasMessageContaining("prior 1.0");
    assertThatThrownBy(() -> new DetectorRates(1, 0.1, 1))
        .hasMessageContaining("not both above 0 and below 1");
  }
}
