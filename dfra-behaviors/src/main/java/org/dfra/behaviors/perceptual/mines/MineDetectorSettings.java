package org.dfra.behaviors.perceptual.mines;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.BayesCombination;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.DempsterShaferCombination;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.DetectorRates;
import org.dfra.core.config.Parameters;
import org.dfra.flow.sensor.CameraImage.Band;
import org.jspecify.annotations.Nullable;

/**
 * Settings of a mine detector, see {@link MineDetectorImpl}.
 *
 * @param fusionMethod {@code bayes} or {@code dempster-shafer}
 * @param fusion the same, as object
 * @param rates of the cameras, as measured
 * @param truePositive of both cameras fused, as measured with that method; null where not given
 * @param falsePositive likewise
 * @param observationSpacing between observations, metres
 * @param associationGate maximum distance of detections of one candidate, metres
 * @param minProbability minimum probability to report
 */
record MineDetectorSettings(
    ImageMineDetectorSettings imageDetector,
    String fusionMethod,
    EvidenceCombination fusion,
    Map<Band, RepeatedDetectionRates> rates,
    @Nullable Double truePositive,
    @Nullable Double falsePositive,
    double observationSpacing,
    double associationGate,
    double minProbability) {

  private static final String BAYES = "bayes";
  private static final String DEMPSTER = "dempster-shafer";
  private static final double RAREST = 1e-6;

  static MineDetectorSettings of(Parameters parameters) {
    ImageMineDetectorSettings usual = ImageMineDetectorSettings.DEFAULT;
    ImageMineDetectorSettings eye =
        new ImageMineDetectorSettings(
            parameters.number("mine_radius", usual.radius(), 0.02, 1),
            parameters.number("mine_height", usual.height(), 0, 1),
            colour(parameters, usual.colour()),
            parameters.number("min_distance", usual.minDistance(), 0, 50),
            parameters.number("max_distance", usual.maxDistance(), 0.5, 100),
            parameters.number("thermal_contrast", usual.minThermalContrast(), 0.05, 50),
            parameters.number("visible_contrast", usual.minVisibleContrast(), 0.01, 5),
            parameters.number("colour_tolerance", usual.colourTolerance(), 0.001, 1));
    if (eye.maxDistance() <= eye.minDistance()) {
      throw parameters.find("max_distance").isPresent()
          ? parameters.fault(
              "max_distance", "more than min_distance, which is " + eye.minDistance() + " m", null)
          : parameters.fault(
              "min_distance", "less than max_distance, which is " + eye.maxDistance() + " m", null);
    }
    double prior = parameters.number("prior", 0.01, RAREST, 1 - RAREST);
    String method = parameters.find("fusion").orElse(BAYES).strip();
    EvidenceCombination fusion =
        switch (method) {
          case BAYES -> new BayesCombination(prior);
          case DEMPSTER -> new DempsterShaferCombination(prior);
          default -> throw parameters.fault("fusion", BAYES + " or " + DEMPSTER, null);
        };
    Map<String, MeasuredRates> measured =
        Map.of(BAYES, shares(parameters, BAYES), DEMPSTER, shares(parameters, DEMPSTER));
    MeasuredRates fused = Objects.requireNonNull(measured.get(method));
    return new MineDetectorSettings(
        eye,
        method,
        fusion,
        rates(parameters),
        fused.truePositive(),
        fused.falsePositive(),
        parameters.number("observation_spacing", 0.5, 0.05, 10),
        parameters.number("association_gate", 0.5, 0.05, 5),
        parameters.number("min_probability", 0.05, 0, 1));
  }

  private static int colour(Parameters reported, int usual) {
    Optional<String> text = reported.find("mine_colour");
    if (text.isEmpty()) {
      return usual;
    }
    String hex = text.get().strip();
    if (!hex.matches("#[0-9A-Fa-f]{6}") || hex.equals("#000000")) {
      throw reported.fault("mine_colour", "red, green and blue as #3F4526, not all 0", null);
    }
    return Integer.parseInt(hex.substring(1), 16);
  }

  private static Map<Band, RepeatedDetectionRates> rates(Parameters reported) {
    Map<Band, RepeatedDetectionRates> rates = new EnumMap<>(Band.class);
    for (Band band : Band.values()) {
      String name = band.name().toLowerCase(Locale.ROOT);
      rates.put(
          band,
          new RepeatedDetectionRates(
              rates(reported, name, ""),
              rates(reported, name, "_after_alarm"),
              rates(reported, name, "_after_no_alarm")));
    }
    return rates;
  }

  /** There is no rate that would be right for all cameras, so there is none by default. */
  private static DetectorRates rates(Parameters reported, String band, String when) {
    return new DetectorRates(
        rate(reported, band + "_true_positive" + when),
        rate(reported, band + "_false_positive" + when),
        1);
  }

  private static double rate(Parameters reported, String name) {
    reported.text(name); // says so where it is not there
    return reported.number(name, Double.NaN, RAREST, 1 - RAREST);
  }

  /** Measured rates of a fusion method; null where they are not given. */
  private record MeasuredRates(@Nullable Double truePositive, @Nullable Double falsePositive) {}

  /** Of every method, chosen or not: so that what is written of the other is looked at too. */
  private static MeasuredRates shares(Parameters reported, String method) {
    String name = method.replace('-', '_');
    return new MeasuredRates(
        share(reported, name + "_true_positive"), share(reported, name + "_false_positive"));
  }

  private static @Nullable Double share(Parameters reported, String name) {
    return reported.find(name).isEmpty() ? null : Double.valueOf(reported.number(name, 0, 0, 1));
  }
}
