package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.dfra.behaviors.perceptual.pose.Field.Errors;
import org.dfra.behaviors.perceptual.pose.PositionEstimatorImpl.TrackerKind;
import org.junit.jupiter.api.Test;

/**
 * How good the trackers are on a simulated field. Every figure is of 20 seeds where {@code
 * -Ddfra.full=true}, otherwise of the first 12, and a bound must hold by three standard errors of
 * their mean: of 20 it then fails by chance less than once in five hundred for other seeds, and
 * never for these.
 */
class TrackersOnFieldTest {

  private static final int SEEDS = Boolean.getBoolean("dfra.full") ? 20 : 12;
  private static final double FROM = 30;
  private static final double SECONDS = 240;

  /** A mean and its standard error. */
  private record Figure(double mean, double error) {

    static Figure of(double[] values) {
      double mean = Arrays.stream(values).average().orElseThrow();
      double square = Arrays.stream(values).map(v -> (v - mean) * (v - mean)).sum();
      return new Figure(mean, Math.sqrt(square / (values.length - 1) / values.length));
    }

    double atMost() {
      return mean + 3 * error;
    }

    double atLeast() {
      return mean - 3 * error;
    }
  }

  /** What more than one test needs is computed once. */
  private record Question(TrackerKind kind, Errors errors, double assumedBias) {}

  private static final Map<Question, List<Ride>> RIDES = new HashMap<>();

  /** The same fields for every tracker; a ride changes nothing of its field. */
  private static final Map<Errors, List<Field>> FIELDS = new HashMap<>();

  private static double[] ride(
      TrackerKind kind, Errors errors, double assumedBias, ToDoubleFunction<Ride> figure) {
    return RIDES
        .computeIfAbsent(new Question(kind, errors, assumedBias), TrackersOnFieldTest::rides)
        .stream()
        .mapToDouble(figure)
        .toArray();
  }

  private static List<Ride> rides(Question question) {
    List<Field> fields = FIELDS.computeIfAbsent(question.errors(), TrackersOnFieldTest::fields);
    return fields.stream()
        .map(
            field -> {
              PoseTracker tracker =
                  question
                      .kind()
                      .create(TrackerTable.settings(question.assumedBias()), "r/map", Field.DATUM);
              return new Ride(field, tracker).go(FROM).compare(FROM, SECONDS);
            })
        .toList();
  }

  private static List<Field> fields(Errors errors) {
    return IntStream.range(0, SEEDS).mapToObj(seed -> new Field(seed, errors, SECONDS)).toList();
  }

  private static Figure ratio(double[] values, double[] to) {
    return Figure.of(
        IntStream.range(0, values.length).mapToDouble(i -> values[i] / to[i]).toArray());
  }

  @Test
  void isFarBetterThanRawFixesWhenTheirNoiseIsWhite() {
    double[] kalman = ride(TrackerKind.KALMAN, Errors.WHITE, 0, Ride::rms);
    double[] history = ride(TrackerKind.FIX_WINDOW, Errors.WHITE, 0, Ride::rms);
    double[] raw = ride(TrackerKind.RAW, Errors.WHITE, 0, Ride::rms);
    // Required is 30 % better; dead reckoning over a lane averages tens of fixes.
    assertThat(ratio(kalman, raw).atMost()).isLessThan(0.7);
    assertThat(ratio(kalman, history).atMost()).as("Kalman to heuristic").isLessThan(1);
    assertThat(ratio(history, raw).atMost()).as("heuristic to raw").isLessThan(1);
  }

  @Test
  void isBetterThanRawFixesWhoseErrorIsSlow() {
    Errors slow = Errors.WHITE.withBias(1.5);
    double[] kalman = ride(TrackerKind.KALMAN, slow, 1.5, Ride::rms);
    double[] raw = ride(TrackerKind.RAW, slow, 1.5, Ride::rms);
    // Two receivers whose errors are their own: no better than 1/√2 without the past.
    assertThat(ratio(kalman, raw).atMost()).isLessThan(0.75);
  }

  @Test
  void isAsGoodAsItSays() {
    double[] nees = ride(TrackerKind.KALMAN, Errors.WHITE.withBias(1.5), 1.5, Ride::nees);
    // Two numbers are estimated: 2 for a linear filter that knows all errors. Slip lasts for 2 s
    // and
    // is not white, encoders and turning are simplified; from half of 2 to one and a half is
    // enough.
    Figure figure = Figure.of(nees);
    assertThat(figure.atMost()).as("not overcautious: %s", figure).isGreaterThan(1);
    assertThat(figure.atLeast()).as("not overconfident: %s", figure).isLessThan(3);
  }

  @Test
  void knowsItsYaw() {
    double[] yaw = ride(TrackerKind.KALMAN, Errors.WHITE.withBias(1.5), 1.5, Ride::yawRms);
    // A course is worth 0.083 rad, and there are two a second.
    assertThat(Figure.of(yaw).atMost()).isLessThan(0.04);
  }

  @Test
  void learnsHowWheelsTurnWhereThereIsNoGyro() {
    Errors noGyro = Errors.WHITE.withoutGyro(0.3);
    double[] kalman = ride(TrackerKind.KALMAN, noGyro, 0, Ride::rms);
    double[] raw = ride(TrackerKind.RAW, noGyro, 0, Ride::rms);
    assertThat(ratio(kalman, raw).atMost()).isLessThan(0.7);
  }

  @Test
  void toleratesNoiseThatIsNotAsConfigured() {
    double[] kalman = ride(TrackerKind.KALMAN, Errors.WHITE, 1.5, Ride::rms);
    double[] raw = ride(TrackerKind.RAW, Errors.WHITE, 1.5, Ride::rms);
    assertThat(ratio(kalman, raw).atMost()).isLessThan(0.7);
  }
}
