package org.dfra.behaviors.perceptual.pose;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dfra.behaviors.perceptual.pose.FilterInput.LocalFix;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.Transform;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class FixPreprocessorTest {

  private static final Field FIELD = new Field(1, new Field.Errors(0.6, 0, 0.2, true, 100), 1);

  private final FixPreprocessor intake =
      new FixPreprocessor(TrackerSettings.GpsErrors.DEFAULT, Field.DATUM);

  private @Nullable LocalFix take(GpsFix fix, String source, double received) {
    return intake.process(fix, source, Transform.translation(0.3, 0.1, 1), FIELD.host(received));
  }

  private static GpsFix fix(double t) {
    return FIELD.fix(t, 3, 4, 0, 1);
  }

  @Test
  void putsAFixOnTheRobotsClockAndMap() {
    LocalFix local = take(fix(5), "a", 5.4);
    assertThat(local).isNotNull();
    // Received 0.4 s later, of which 0.16 s are known to be latency.
    assertThat(EpochNanos.instant(local.time())).isBetween(FIELD.host(5.239), FIELD.host(5.241));
    assertThat(local.east()).isCloseTo(3, within(1e-6));
    assertThat(local.north()).isCloseTo(4, within(1e-6));
    assertThat(local.course()).as("northward").isCloseTo(Math.PI / 2, within(1e-9));
    assertThat(local.forward()).isEqualTo(0.3);
    assertThat(local.left()).isEqualTo(0.1);
  }

  @Test
  void usesTheLeastDelayedFix() {
    take(fix(5), "a", 5.9);
    take(fix(6), "a", 6.16);
    LocalFix late = take(fix(7), "a", 8.5);
    assertThat(late).isNotNull();
    assertThat(EpochNanos.instant(late.time())).isBetween(FIELD.host(6.999), FIELD.host(7.001));
  }

  @Test
  void doesNotBelieveAReceiverThatIsWrongAboutUtc() {
    for (int i = 0; i < 10; i++) {
      take(fix(i), "a", i + 0.2);
    }
    take(fix(3600), "b", 10.2);
    LocalFix good = take(fix(11), "a", 11.2);
    assertThat(good).isNotNull();
    assertThat(EpochNanos.instant(good.time())).isBetween(FIELD.host(11), FIELD.host(11.05));
  }

  @Test
  void leavesOutWhatIsRepeatedHeldOrNone() {
    GpsFix fix = fix(5);
    assertThat(take(fix, "a", 5.2)).isNotNull();
    assertThat(take(fix, "a", 5.3)).isNull();
    assertThat(take(fix, "b", 5.3)).as("another receiver at the same moment").isNotNull();
    GpsFix held = new GpsFix(GpsFix.Mode.POSITION_HOLD, Field.DATUM, Field.utc(6), 0, 0, 2, 8, 8);
    assertThat(take(held, "a", 6.2)).isNull();
    GpsFix none = new GpsFix(GpsFix.Mode.NONE, null, Field.utc(7), 0, 0, 2, 8, 0);
    assertThat(take(none, "a", 7.2)).isNull();
  }

  @Test
  void hasNoCourseFromAFixThatIsSlow() {
    LocalFix slow = take(FIELD.fix(5, 0, 0, 0.3, 0), "a", 5.2);
    assertThat(slow).isNotNull();
    assertThat(slow.course()).isNaN();
  }

  @Test
  void takesAFixWhoseSpeedIsUnknown() {
    GpsFix fix =
        new GpsFix(GpsFix.Mode.FIX_3D, Field.DATUM, Field.utc(5), Double.NaN, Double.NaN, 2, 8, 8);
    LocalFix local = take(fix, "a", 5.2);
    assertThat(local).isNotNull();
    assertThat(local.course()).isNaN();
    assertThat(local.speed()).as("finite, for estimates must be").isZero();
  }

  @Test
  void isLessSureWhenDiluted() {
    GpsFix poor = new GpsFix(GpsFix.Mode.FIX_3D, Field.DATUM, Field.utc(5), 0, 0, 6, 8, 4);
    LocalFix local = take(poor, "a", 5.2);
    assertThat(local).isNotNull();
    assertThat(local.sigma()).isCloseTo(1.2, within(1e-12));
  }

  @Test
  void givesASilentReceiversPlaceToAnother() {
    for (String each : new String[] {"a", "b", "c"}) {
      assertThat(take(fix(5), each, 5.2)).isNotNull();
    }
    assertThat(take(fix(6), "d", 6.2)).isNull();
    for (int i = 7; i < 70; i++) {
      take(fix(i), "a", i + 0.2);
      take(fix(i), "b", i + 0.2);
    }
    LocalFix fourth = take(fix(70), "d", 70.2);
    assertThat(fourth).isNotNull();
    assertThat(fourth.isNewSource()).isTrue();
    LocalFix next = take(fix(71), "d", 71.2);
    assertThat(next).isNotNull();
    assertThat(next.isNewSource()).isFalse();
    assertThat(next.slot()).isEqualTo(fourth.slot());
  }
}
