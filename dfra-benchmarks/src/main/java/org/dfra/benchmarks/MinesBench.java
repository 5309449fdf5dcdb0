package org.dfra.benchmarks;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.BayesCombination;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.DempsterShaferCombination;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.PreviousResult;
import org.dfra.experiments.mines.DetectionCounter;
import org.dfra.experiments.mines.DetectionCounter.DetectionRate;
import org.dfra.experiments.mines.FusedDetectionCounter;
import org.dfra.experiments.mines.MineLaneObservations;
import org.dfra.experiments.navigation.ConfidenceInterval;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * Measures the detection rates of the mine detector's cameras per image, and of both together. It
 * prints the rates of config/modules/mine-detector.properties, each under its name there.
 *
 * <p>The rates of each camera come from one half of the fields; the results of both cameras with
 * these rates come from the other half.
 */
final class MinesBench implements Bench {

  private static final int FIELDS = 60;
  private static final double PRIOR = 0.01; // as in the properties
  private static final double MOST_OVERLOOKED = 0.25;
  private static final double MOST_MISTAKEN = 0.05;
  private static final double MOST_ERROR = 0.5; // metres

  @Override
  public void run(Report report) throws Exception {
    List<MineLaneObservations> lanes = lanes();
    long looks = lanes.stream().mapToLong(lane -> lane.observations().size()).sum();
    report.say(
        FIELDS
            + " fields with mines, stones, posts and hedges, "
            + looks
            + " looks with both cameras. Intervals are Wilson's, of 95 %.");
    List<MineLaneObservations> first = lanes.subList(0, FIELDS / 2);
    List<MineLaneObservations> second = lanes.subList(FIELDS / 2, FIELDS);
    Map<Band, RepeatedDetectionRates> rates = new EnumMap<>(Band.class);
    for (Band band : Band.values()) {
      DetectionCounter counter = new DetectionCounter(band);
      first.forEach(counter::add);
      record(report, band.name().toLowerCase(Locale.ROOT), counter);
      rates.put(band, counter.rates());
    }
    together(
        report,
        "bayes",
        new BayesCombination(PRIOR),
        rates,
        second,
        MOST_OVERLOOKED,
        MOST_MISTAKEN);
    together(
        report,
        "dempster_shafer",
        new DempsterShaferCombination(PRIOR),
        rates,
        second,
        Double.POSITIVE_INFINITY, // included for comparison
        Double.POSITIVE_INFINITY);
  }

  private static void record(Report report, String band, DetectionCounter counter) {
    for (PreviousResult before : PreviousResult.values()) {
      String when =
          before == PreviousResult.NONE ? "" : "_after_" + before.name().toLowerCase(Locale.ROOT);
      record(report, band + "_true_positive" + when, counter.truePositives(before));
      record(report, band + "_false_positive" + when, counter.falsePositives(before));
    }
  }

  private static void record(Report report, String name, DetectionRate rate) {
    ConfidenceInterval interval = rate.interval();
    report.figure(name, rate.value(), "");
    report.figure(name + ", low", interval.low(), "");
    report.figure(name + ", high", interval.high(), "");
    report.say("    " + rate.times() + " of " + rate.trials());
  }

  private static void together(
      Report report,
      String name,
      EvidenceCombination fusion,
      Map<Band, RepeatedDetectionRates> rates,
      List<MineLaneObservations> lanes,
      double mostOverlooked,
      double mostMistaken) {
    FusedDetectionCounter counter = new FusedDetectionCounter(fusion, rates);
    lanes.forEach(counter::add);
    record(report, name + "_true_positive", counter.truePositives());
    record(report, name + "_false_positive", counter.falsePositives());
    DetectionRate found = counter.recall();
    DetectionRate mistaken = counter.falseDiscoveries();
    report.say(
        "  in the end "
            + found.times()
            + " of "
            + found.trials()
            + " mines found, "
            + found.interval()
            + "; "
            + mistaken.times()
            + " of "
            + mistaken.trials()
            + " taken for mines are none, "
            + mistaken.interval());
    report.figure(
        name + ": mines overlooked in the end", 1 - found.interval().value(), mostOverlooked, "");
    report.figure(
        name + ": taken for mines in the end and none",
        mistaken.interval().value(),
        mostMistaken,
        "");
    report.figure(
        name + ": error of a mine's position, RMS", counter.positionRmse(), MOST_ERROR, "m");
  }

  private static List<MineLaneObservations> lanes()
      throws ExecutionException, InterruptedException {
    ExecutorService threads =
        Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
    try {
      List<Future<MineLaneObservations>> futures = new ArrayList<>();
      for (long seed = 1; seed <= FIELDS; seed++) {
        long each = seed;
        futures.add(threads.submit(() -> MineLaneObservations.of(each)));
      }
      List<MineLaneObservations> lanes = new ArrayList<>();
      for (Future<MineLaneObservations> each : futures) {
        lanes.add(each.get());
      }
      return lanes;
    } finally {
      threads.shutdownNow();
    }
  }
}
