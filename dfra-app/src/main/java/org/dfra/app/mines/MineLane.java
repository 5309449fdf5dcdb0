package org.dfra.app.mines;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.behaviors.perceptual.mines.Eye;
import org.dfra.behaviors.perceptual.mines.EyeSettings;
import org.dfra.behaviors.perceptual.mines.Glance;
import org.dfra.behaviors.perceptual.mines.Look;
import org.dfra.behaviors.perceptual.mines.Spot;
import org.dfra.behaviors.perceptual.mines.Viewpoint;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.CameraImage.Band;
import org.dfra.geometry.Transform;
import org.dfra.sim.body.CameraView;
import org.dfra.sim.device.camera.FrameEncoder;
import org.dfra.sim.world.MineSighting;
import org.dfra.sim.world.SimulatedRobot;
import org.dfra.sim.world.TruePose;
import org.dfra.sim.world.World;
import org.dfra.sim.world.description.Mount;
import org.dfra.sim.world.description.WorldDescription;

/**
 * What a robot sees that drives along a field's lane and looks every half metre. Where it stands is
 * known exactly, and images are encoded and decoded as those of its cameras. The same seed gives
 * the same looks.
 *
 * @param mines where they truly are, by name, on the map
 * @param looks in their order
 */
public record MineLane(Map<String, Spot> mines, List<LaneLook> looks) {

  private static final Instant BEGIN = Instant.parse("2026-11-21T12:00:00Z");
  private static final Duration STEP = Duration.ofMillis(500); // half a metre at 1 m/s
  private static final int LOOKS = 36;
  private static final int FEWEST_PIXELS = 12; // of a mine that can be seen at all

  public MineLane {
    mines = Map.copyOf(mines);
    looks = List.copyOf(looks);
  }

  /**
   * A look.
   *
   * @param look what was seen
   * @param shown names of the mines that truly are in the images, by band
   */
  public record LaneLook(Look look, Map<Band, Set<String>> shown) {

    /** Whether an image truly shows a mine, and as well as is needed to find it. */
    boolean shows(Look.View view, String mine, Spot spot) {
      return shown.getOrDefault(view.glance().band(), Set.of()).contains(mine) && view.sees(spot);
    }
  }

  /** The whole lane of the field of that seed. */
  public static MineLane of(long seed) {
    WorldDescription field = MineField.of(seed);
    World world = World.of(field, BEGIN);
    Map<String, Spot> mines = new HashMap<>();
    field.mines().forEach(mine -> mines.put(mine.name(), new Spot(mine.east(), mine.north())));
    Map<Band, OneCamera> cameras = new EnumMap<>(Band.class);
    cameras.put(Band.VISIBLE, new OneCamera(world, MineField.CAMERA, Band.VISIBLE));
    cameras.put(Band.THERMAL, new OneCamera(world, MineField.THERMAL, Band.THERMAL));
    List<LaneLook> looks = new ArrayList<>();
    Instant time = BEGIN;
    for (int i = 0; i < LOOKS; i++) {
      world.robot(MineField.ROBOT).drive("drive").drive(time, 1, 0, 2, 2);
      time = time.plus(STEP);
      world.advanceTo(time);
      List<Look.View> views = new ArrayList<>();
      Map<Band, Set<String>> shown = new EnumMap<>(Band.class);
      for (OneCamera each : cameras.values()) {
        views.add(each.look(time));
        shown.put(each.band, each.shown(time));
      }
      looks.add(new LaneLook(new Look(views), shown));
    }
    return new MineLane(mines, looks);
  }

  /** A camera of the robot, and what searches its images. */
  private static final class OneCamera {
    private final World world;
    private final String name;
    private final Band band;
    private final CameraView view;
    private final FrameEncoder encoder;
    private final Eye eye = new Eye(EyeSettings.DEFAULT);

    OneCamera(World world, String name, Band band) {
      SimulatedRobot robot = world.robot(MineField.ROBOT);
      this.world = world;
      this.name = name;
      this.band = band;
      this.view = robot.cameraView(name);
      this.encoder = new FrameEncoder(band == Band.THERMAL);
    }

    Look.View look(Instant time) {
      CameraView.Frame frame = view.look(time);
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
      Mount at = MineField.MOUNT;
      Transform mount = Transform.of(at.x(), at.y(), at.z(), at.roll(), at.pitch(), at.yaw());
      Glance glance =
          eye.look(image, mount)
              .orElseThrow(() -> new IllegalStateException(image + " cannot be decoded"));
      TruePose pose = world.truth().pose(MineField.ROBOT, time);
      return new Look.View(new Viewpoint(pose.east(), pose.north(), pose.yaw()), glance);
    }

    Set<String> shown(Instant time) {
      Set<String> names = new HashSet<>();
      for (MineSighting each : world.truth().minesInView(MineField.ROBOT, name, time)) {
        if (each.pixels() >= FEWEST_PIXELS) {
          names.add(each.mine());
        }
      }
      return names;
    }
  }
}
