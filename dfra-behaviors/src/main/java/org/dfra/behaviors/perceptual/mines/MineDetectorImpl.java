package org.dfra.behaviors.perceptual.mines;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dfra.behaviors.perceptual.mines.MineObservation.Viewpoint;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.PerceptualSchemaImpl;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.perceptual.MineDetector;
import org.dfra.flow.perceptual.MinePercept;
import org.dfra.flow.perceptual.MinePercept.Detection;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.flow.sensor.CameraSensor;
import org.dfra.geometry.Transform;
import org.dfra.persona.PerceptualSchemaAttributes;
import org.dfra.persona.PoseAttributes;
import org.jspecify.annotations.Nullable;

/**
 * Detects mines on the ground with all visible and thermal cameras of its robot and its position
 * estimator; see {@link ImageMineDetector} and {@link MineCandidateMap}. A camera's persona gives
 * its mount on the robot's base; a camera mounted on anything else, such as a head, is not used,
 * and the log reports that.
 *
 * <p>It takes an observation when the robot has moved by {@code observation_spacing} or rotated by
 * 0.3 rad since the last one, with the next image of each band. It takes none while the yaw's
 * standard deviation exceeds 0.15 rad or the yaw rate 0.5 rad/s. Its percept has all detections
 * since its start.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code fusion}: {@code bayes} or {@code dempster-shafer}; default bayes
 *   <li>{@code prior}: probability of a mine at a position without observations, above 0 and below
 *       1; default 0.01
 *   <li>{@code visible_true_positive}, {@code visible_false_positive}: probability of an alarm in
 *       one observation of a visible camera where there is a mine, and where there is none; with
 *       the suffixes {@code _after_alarm} and {@code _after_no_alarm} in a repeated observation;
 *       the same with {@code thermal}; all required
 *   <li>{@code bayes_true_positive}, {@code bayes_false_positive}, {@code
 *       dempster_shafer_true_positive}, {@code dempster_shafer_false_positive}: of both cameras
 *       fused; shown in its persona only
 *   <li>{@code mine_radius}, {@code mine_height}: metres; {@code mine_colour}: as {@code #3F4526}
 *   <li>{@code min_distance}, {@code max_distance}: distance range, metres forward of the base;
 *       default 0.9 and 3.5
 *   <li>{@code thermal_contrast}: kelvin, default 1; {@code visible_contrast}: natural logarithm,
 *       default 0.18; {@code colour_tolerance}: default 0.03; see {@link ImageMineDetectorSettings}
 *   <li>{@code observation_spacing}: metres, 0.05 to 10, default 0.5; {@code association_gate}:
 *       metres, 0.05 to 5, default 0.5
 *   <li>{@code min_probability}: minimum probability to report, 0 to 1; default 0.05
 *   <li>{@code position}: name of the estimator to use; default the first
 *   <li>{@code max_age}: as for every perceptual schema; default 5
 * </ul>
 */
public final class MineDetectorImpl extends PerceptualSchemaImpl<MinePercept>
    implements MineDetector {

  private static final String EARTH = "earth";
  private static final double MOST_YAW_SIGMA = 0.15; // radians
  private static final double MAX_YAW_RATE = 0.5; // radians per second
  private static final double TURN = 0.3; // radians

  private final MineDetectorSettings detectorSettings;
  private final String base;
  private final Object lock = new Object();

  @GuardedBy("lock")
  private final MineCandidateMap places;

  @GuardedBy("lock")
  private final PoseBuffer trail = new PoseBuffer();

  @GuardedBy("lock")
  private final ImageSynchronizer<ImageSource> pairing = new ImageSynchronizer<>();

  // by camera
  @GuardedBy("lock")
  private final Map<String, ImageMineDetector> imageDetectors = new HashMap<>();

  // cameras
  @GuardedBy("lock")
  private final Set<String> unusable = new HashSet<>();

  @GuardedBy("lock")
  private final Map<Band, Integer> broken = new EnumMap<>(Band.class);

  @GuardedBy("lock")
  private @Nullable Viewpoint lastLook;

  @GuardedBy("lock")
  private List<Detection> detections = List.of();

  /** Source of an image: its camera, and the poses of camera and robot. */
  private record ImageSource(String camera, Transform mount, Viewpoint from) {}

  /**
   * @throws org.dfra.core.config.ConfigurationException if a parameter is missing or invalid
   */
  public MineDetectorImpl(ModuleContext context) {
    super(
        context,
        "mines on the ground, from visible and thermal images",
        "DFRA",
        "1",
        MinePercept.class,
        "MinePercept",
        5);
    this.detectorSettings = MineDetectorSettings.of(settings());
    this.places =
        new MineCandidateMap(
            detectorSettings.fusion(),
            detectorSettings.rates(),
            detectorSettings.associationGate(),
            detectorSettings.observationSpacing());
    this.base = context.robot() + "/base_link";
    declareInput(
        PositionEstimator.class, "position", PoseEstimate.class, (source, pose) -> take(pose));
    declareInputFromAll(CameraSensor.class, CameraImage.class, this::take);
    parameterTable()
        .declareReadOnly("undecoded", "images that could not be decoded, by band", this::undecoded);
  }

  private String undecoded() {
    synchronized (lock) {
      return broken.toString();
    }
  }

  private void take(PoseEstimate pose) {
    synchronized (lock) {
      trail.add(pose);
    }
  }

  private void take(ModuleListing<?> source, CameraImage image) {
    synchronized (lock) {
      Optional<Transform> mount = mount(source);
      Optional<PoseEstimate> pose = trail.nearest(image.measured());
      if (mount.isEmpty() || pose.isEmpty()) {
        return;
      }
      Viewpoint from = trail.extrapolate(image.measured(), pose.get());
      boolean isSteady =
          pose.get().yawSigma() <= MOST_YAW_SIGMA && Math.abs(pose.get().yawRate()) <= MAX_YAW_RATE;
      List<ImageSynchronizer.TaggedImage<ImageSource>> complete =
          isSteady && isElsewhere(from)
              ? pairing.add(image, new ImageSource(source.path(), mount.get(), from))
              : List.of();
      if (complete.isEmpty()) {
        setPercept(new MinePercept(image.measured(), EARTH, detections));
      } else {
        lastLook = from;
        look(complete, image.measured());
      }
    }
  }

  @GuardedBy("lock")
  private boolean isElsewhere(Viewpoint from) {
    Viewpoint last = lastLook;
    return last == null
        || last.distance(from) >= detectorSettings.observationSpacing()
        || last.yawDifference(from) >= TURN;
  }

  /** Mount of the camera on the base, from its persona; empty if it has none. */
  @GuardedBy("lock")
  private Optional<Transform> mount(ModuleListing<?> source) {
    Optional<PoseAttributes> pose = source.attributes(PoseAttributes.class);
    if (pose.isEmpty() || !pose.get().parent().equals(base)) {
      if (unusable.add(source.path())) {
        log.warn(
            "{}: {} is not used, since it is mounted on {} and not on {}; set its mount_frame",
            identification().path(),
            source.path(),
            pose.map(PoseAttributes::parent).orElse("an unknown frame"),
            base);
      }
      return Optional.empty();
    }
    return pose.map(at -> Transform.of(at.x(), at.y(), at.z(), at.roll(), at.pitch(), at.yaw()));
  }

  @GuardedBy("lock")
  private void look(List<ImageSynchronizer.TaggedImage<ImageSource>> images, Instant measured) {
    List<MineObservation.LocatedDetections> views = new ArrayList<>();
    for (ImageSynchronizer.TaggedImage<ImageSource> each : images) {
      ImageSource with = each.tag();
      imageDetectors
          .computeIfAbsent(
              with.camera(), unused -> new ImageMineDetector(detectorSettings.imageDetector()))
          .detect(each.image(), with.mount())
          .ifPresentOrElse(
              glance -> views.add(new MineObservation.LocatedDetections(with.from(), glance)),
              () -> broken.merge(each.image().band(), 1, Integer::sum));
    }
    if (!views.isEmpty()) {
      places.add(new MineObservation(views));
      PoseBuffer poses = trail;
      detections =
          places.candidates(detectorSettings.minProbability()).stream()
              .map(
                  each ->
                      new Detection(
                          poses.toGeo(each.position()), each.probability(), each.observations()))
              .toList();
      publishPercept(new MinePercept(measured, EARTH, detections));
    }
  }

  @Override
  protected PerceptualSchemaAttributes schemaAttributes() {
    return new PerceptualSchemaAttributes(
        "MinePercept",
        "probability",
        detectorSettings.fusionMethod(),
        detectorSettings.truePositive(),
        detectorSettings.falsePositive());
  }

  @Override
  public MinePercept mines() {
    return percept();
  }
}
