package org.dfra.experiments.mines;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector.ImageDetections;
import org.dfra.behaviors.perceptual.mines.ImageMineDetectorSettings;
import org.dfra.behaviors.perceptual.mines.MineObservation;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.MineObservation.Viewpoint;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.Transform;
import org.dfra.sim.device.camera.FrameEncoder;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.world.GroundTruth.GroundTruthPose;
import org.dfra.sim.world.GroundTruth.MineSighting;
import org.dfra.sim.world.SimulatedRobot;
import org.dfra.sim.world.World;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.WorldDescription;

/**
 * The images of a robot that drives along a field's lane and takes one every half metre. Its pose
 * is known exactly, and images are encoded and decoded as those of its cameras. The same seed gives
 * the same images.
 *
 * @param mines their true positions, by name, on the map
 * @param observations in their order
 */
public record MineLaneObservations(
    Map<String, GroundPoint> mines, List<LaneObservation> observations) {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final Duration STEP = Duration.ofMillis(500); // half a metre at 1 m/s
  private static final int LOOKS = 36;
  private static final int FEWEST_PIXELS = 12; // of a mine that can be seen at all

  public MineLaneObservations {
    mines = Map.copyOf(mines);
    observations = List.copyOf(observations);
  }

  /**
   * An observation.
   *
   * @param observation the detections
   * @param visibleMines names of the mines that are truly in the images, by band
   */
  public record LaneObservation(MineObservation observation, Map<Band, Set<String>> visibleMines) {

    /** Whether an image truly shows a mine, and well enough to detect it. */
    boolean shows(MineObservation.LocatedDetections view, String mine, GroundPoint spot) {
      return visibleMines.getOrDefault(view.detections().band(), Set.of()).contains(mine)
          && view.covers(spot);
    }
  }

  /** The whole lane of the field with this seed. */
  public static MineLaneObservations of(long seed) {
    WorldDescription field = MineField.of(seed);
    World world = World.of(field, BEGIN);
    Map<String, GroundPoint> mines = new HashMap<>();
    field
        .mines()
        .forEach(mine -> mines.put(mine.name(), new GroundPoint(mine.east(), mine.north())));
    Map<Band, OneCamera> cameras = new EnumMap<>(Band.class);
    cameras.put(Band.VISIBLE, new OneCamera(world, MineField.CAMERA, Band.VISIBLE));
    cameras.put(Band.THERMAL, new OneCamera(world, MineField.THERMAL, Band.THERMAL));
    List<LaneObservation> looks = new ArrayList<>();
    Instant time = BEGIN;
    for (int i = 0; i < LOOKS; i++) {
      world.robot(MineField.ROBOT).drivetrain("drive").drive(time, 1, 0, 2, 2);
      time = time.plus(STEP);
      world.advanceTo(time);
      List<MineObservation.LocatedDetections> views = new ArrayList<>();
      Map<Band, Set<String>> shown = new EnumMap<>(Band.class);
      for (OneCamera each : cameras.values()) {
        views.add(each.look(time));
        shown.put(each.band, each.shown(time));
      }
      looks.add(new LaneObservation(new MineObservation(views), shown));
    }
    return new MineLaneObservations(mines, looks);
  }

  /** A camera of the robot, and its detector. */
  private static final class OneCamera {
    private final World world;
    private final String name;
    private final Band band;
    private final CameraInput view;
    private final FrameEncoder encoder;
    private final ImageMineDetector eye = new ImageMineDetector(ImageMineDetectorSettings.DEFAULT);

    OneCamera(World world, String name, Band band) {
      SimulatedRobot robot = world.robot(MineField.ROBOT);
      this.world = world;
      this.name = name;
      this.band = band;
      this.view = robot.camera(name);
      this.encoder = new FrameEncoder(band);
    }

    MineObservation.LocatedDetections look(Instant time) {
      CameraInput.Frame frame = view.capture(time);
      CameraImage image =
          new CameraImage(
              time,
              MineField.ROBOT + "/" + name,
              band,
              frame.width(),
              frame.height(),
              frame.width() / 2.0 / Math.tan(MineField.FIELD_OF_VIEW / 2),
              encoder.mediaType(),
              encoder.encode(frame));
      MountPose at = MineField.MOUNT;
      Transform mount = Transform.of(at.x(), at.y(), at.z(), at.roll(), at.pitch(), at.yaw());
      ImageDetections glance =
          eye.detect(image, mount)
              .orElseThrow(
                  () -> new IllegalStateException("the image " + image + " cannot be decoded"));
      GroundTruthPose pose = world.groundTruth().pose(MineField.ROBOT, time);
      return new MineObservation.LocatedDetections(
          new Viewpoint(pose.east(), pose.north(), pose.yaw()), glance);
    }

    Set<String> shown(Instant time) {
      Set<String> names = new HashSet<>();
      for (MineSighting each : world.groundTruth().minesInView(MineField.ROBOT, name, time)) {
        if (each.pixels() >= FEWEST_PIXELS) {
          names.add(each.mine());
        }
      }
      return names;
    }
  }
}
