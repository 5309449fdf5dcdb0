package org.dfra.behaviors.perceptual.range;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Duration;
import java.util.Optional;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.perceptual.Clearance;
import org.dfra.flow.perceptual.RangeFilter;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.OdometrySensor;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.flow.sensor.RangeSensor;
import org.dfra.geometry.Transform;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * Publishes the clearance around its robot from the robot's range sensor; see {@link GhostFilter},
 * {@link ClearanceCalculator} and {@link ObstacleMemory}. The sensor's persona gives its mount on
 * the robot's base.
 *
 * <p>The median of the last scans shows another robot at its position of the middle scan. The
 * safety distances of motor schemas allow for that while scans arrive in time. If they are late, as
 * on a busy computer, the clearance is reduced by the distance that another robot can drive in the
 * {@linkplain GhostFilter#lag time} beyond that, up to 1 s.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code median_scans}: number of scans of the median, 1 to 15; default 5; 1 disables the
 *       filter
 *   <li>{@code min_scan_interval}: minimum seconds between two of them, 0 to 1; default 0.09
 *   <li>{@code obstacle_memory}: seconds for which it stores passed obstacles that are out of view,
 *       0 to 120; default 3
 *   <li>{@code max_peer_speed}: maximum speed of other robots, metres per second, 0 to 10; default
 *       0.7
 *   <li>{@code max_range}: maximum range, metres, 1 to 100; longer ranges are ignored; default 8
 *   <li>{@code body_length}, {@code body_width}: of the robot, metres, 0.1 to 10; default those of
 *       an ATRV-Jr
 *   <li>{@code range_sensor}, {@code odometry}: names of the modules to use; default the first
 *       suitable one
 *   <li>{@code max_age}: as for every perceptual schema; default 0.5
 * </ul>
 */
public final class RangeFilterImpl extends PerceptualSchemaImpl<Clearance> implements RangeFilter {

  private static final double LENGTH = 0.78;
  private static final double WIDTH = 0.64;

  /** Tolerated delay of scans, seconds. */
  private static final double USUAL_LAG = 0.1;

  private static final double MOST_LAG = 1; // maximum excess delay used, seconds

  private final ClearanceCalculator surrounds;
  private final GhostFilter filter; // guarded by itself

  @GuardedBy("filter")
  private final ObstacleMemory obstacles;

  @GuardedBy("filter")
  private @Nullable Odometry odometry;

  private final Scheduler time;
  private final String base;
  private final double peerSpeed;
  private final double usualLag; // seconds

  /** See {@link org.dfra.core.module.ModuleImpl}. */
  public RangeFilterImpl(ModuleContext context) {
    super(
        context,
        "clearance around the robot, from its range sensor, without ghost echoes",
        "DFRA",
        "1",
        Clearance.class,
        "Clearance",
        0.5);
    this.time = context.robotTime();
    int scans = (int) settings().number("median_scans", 5, 1, 15);
    double spacing = settings().number("min_scan_interval", 0.09, 0, 1);
    this.filter = new GhostFilter(scans, Duration.ofNanos(Math.round(spacing * 1e9)));
    int middle = scans / 2;
    this.usualLag = middle * spacing + USUAL_LAG;
    this.peerSpeed = settings().number("max_peer_speed", 0.7, 0, 10);
    this.obstacles =
        new ObstacleMemory(
            settings()
                .seconds(
                    "obstacle_memory",
                    Duration.ofSeconds(3),
                    Duration.ZERO,
                    Duration.ofMinutes(2)));
    this.surrounds =
        new ClearanceCalculator(
            settings().number("body_length", LENGTH, 0.1, 10) / 2,
            settings().number("body_width", WIDTH, 0.1, 10) / 2,
            settings().number("max_range", 8, 1, 100));
    this.base = context.robot() + "/base_link";
    declareInput(
        OdometrySensor.class, "odometry", Odometry.class, (source, reading) -> take(reading));
    declareInput(RangeSensor.class, "range_sensor", RangeScan.class, this::take);
  }

  private void take(Odometry reading) {
    synchronized (filter) {
      if (filter.take(reading)) {
        obstacles.clear();
      }
      odometry = reading;
    }
  }

  private void take(ModuleListing<?> source, RangeScan scan) {
    Transform mount = mount(source);
    Clearance clearance;
    synchronized (filter) {
      Optional<float[]> ranges = filter.take(scan);
      if (ranges.isEmpty() || !ClearanceCalculator.hasEnoughBeams(ranges.get())) {
        return;
      }
      Clearance seen =
          surrounds.clearance(scan, ranges.get(), mount, beside(scan, ranges.get(), mount), base);
      double late = Math.max(0, Math.min(MOST_LAG, filter.lag() - usualLag));
      clearance = late > 0 ? surrounds.reducedBy(seen, peerSpeed * late) : seen;
    }
    publishPercept(clearance);
  }

  /** The passed obstacles; the caller holds the filter's lock. */
  @GuardedBy("filter")
  private ClearanceCalculator.SideClearance beside(
      RangeScan scan, float[] ranges, Transform mount) {
    ClearanceCalculator.SideClearance beside = surrounds.new SideClearance();
    @Nullable Odometry at = odometry;
    if (at != null) {
      obstacles.take(scan, ranges, mount, at, time.nanos());
      obstacles.forEach(at, beside);
    }
    return beside;
  }

  /** Mount of the sensor, from its persona; the front of the body without one. */
  private Transform mount(ModuleListing<?> source) {
    return source
        .attributes(PoseAttributes.class)
        .map(at -> Transform.of(at.x(), at.y(), at.z(), at.roll(), at.pitch(), at.yaw()))
        .orElseGet(() -> Transform.translation(surrounds.halfLength(), 0, 0));
  }

  @Override
  protected PerceptualSchemaAttributes schemaAttributes() {
    return new PerceptualSchemaAttributes("Clearance", null, "median", null, null);
  }

  @Override
  public Clearance clearance() {
    return percept();
  }
}
