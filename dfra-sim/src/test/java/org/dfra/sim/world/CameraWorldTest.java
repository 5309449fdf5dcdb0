package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.ugv;

import java.util.List;
import org.dfra.core.config.SourceLocation;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.world.GroundTruth.MineSighting;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.MineDescription;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.shape.PlanarShape;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.dfra.sim.world.shape.PlanarShape.Polygon;
import org.dfra.sim.world.shape.PlanarShape.Vertex;
import org.junit.jupiter.api.Test;

/**
 * The robot stands at (30, 20) and heads east; its camera is 1 m above its middle. The picture has
 * 320 × 240 pixels and takes in 90° from left to right, so its focal length is 160 pixels: what is
 * x ahead, y to the left and z above the camera is in column 160 − 160 y/x, row 120 − 160 z/x.
 */
class CameraWorldTest {

  private static final int MAGENTA = 0xFF00FF;

  private static DeviceDescription camera(DeviceKind kind, MountPose mount) {
    return new DeviceDescription(kind, "camera", mount)
        .with("field_of_view", Math.PI / 2)
        .with("white_noise_sigma", 0);
  }

  private static WorldDescription with(WorldDescription world, DeviceDescription camera) {
    return world.with(ugv("atrv1").with(camera));
  }

  private static CameraInput.Frame look(WorldDescription world, DeviceKind kind) {
    return World.of(with(world, camera(kind, MountPose.at(0, 0, 1))), START)
        .robot("atrv1")
        .camera("camera")
        .capture(START);
  }

  private static int at(CameraInput.Frame frame, int column, int row) {
    return frame.samples()[row * frame.width() + column];
  }

  private static int red(int colour) {
    return colour >> 16 & 0xFF;
  }

  private static int green(int colour) {
    return colour >> 8 & 0xFF;
  }

  private static int blue(int colour) {
    return colour & 0xFF;
  }

  private static boolean isMagenta(CameraInput.Frame frame, int column, int row) {
    int colour = at(frame, column, row);
    return red(colour) > 60 && blue(colour) > 60 && green(colour) < 30;
  }

  private static ObstacleDescription magenta(PlanarShape outline, double height) {
    return new ObstacleDescription("thing", outline, height, 0.5, MAGENTA, SourceLocation.CODE);
  }

  @Test
  void theHorizonIsLevelAndInTheMiddle() {
    CameraInput.Frame frame = look(field(1), DeviceKind.CAMERA);
    assertThat(frame.width()).isEqualTo(320);
    assertThat(frame.height()).isEqualTo(240);
    for (int column = 0; column < 320; column++) {
      int sky = at(frame, column, 119);
      int ground = at(frame, column, 121);
      assertThat(blue(sky)).as("sky in column %d", column).isGreaterThan(green(sky));
      assertThat(green(ground)).as("ground in column %d", column).isGreaterThan(blue(ground));
    }
  }

  /**
   * A post of 0.2 m, 8 m ahead and 4 m to the left, lies 26.565° to the left and is 8.944 m away,
   * so it spans 1.281° to both sides: columns 75.5 to 84.4. It reaches from 1 m below to 1 m above
   * the camera: rows 99.6 to 140.4 at its near side, 7.85 m ahead. Its twelve sides lie up to 3.4 %
   * of its radius inside.
   */
  @Test
  void aPostIsWhereThePinHoleTakesIt() {
    CameraInput.Frame frame =
        look(field(1).with(magenta(new Disc(38, 24, 0.2), 2)), DeviceKind.CAMERA);
    int left = 320;
    int right = -1;
    int top = 240;
    int bottom = -1;
    for (int row = 0; row < 240; row++) {
      for (int column = 0; column < 320; column++) {
        if (isMagenta(frame, column, row)) {
          left = Math.min(left, column);
          right = Math.max(right, column);
          top = Math.min(top, row);
          bottom = Math.max(bottom, row);
        }
      }
    }
    assertThat(left).isBetween(75, 76);
    assertThat(right).isBetween(83, 84);
    assertThat(top).isBetween(99, 100);
    assertThat(bottom).isBetween(139, 140);
    assertThat(isMagenta(frame, 80, 120)).isTrue();
  }

  /**
   * A mine 4 m ahead: 0.32 m are 12.8 columns; its top edge behind is 0.917 m below the camera at
   * 4.16 m, row 155.3, its lower edge in front 1 m at 3.84 m, row 161.7.
   */
  @Test
  void aMineAheadIsInTheLowerMiddle() {
    World world =
        World.of(
            with(
                field(1).with(new MineDescription("mine", 34, 20)),
                camera(DeviceKind.CAMERA, MountPose.at(0, 0, 1))),
            START);
    assertThat(world.groundTruth().minesInView("atrv1", "camera", START))
        .singleElement()
        .satisfies(
            seen -> {
              assertThat(seen.mine()).isEqualTo("mine");
              assertThat(seen.column()).isCloseTo(160, within(0.6));
              assertThat(seen.row()).isCloseTo(158.3, within(1.0));
              assertThat(seen.pixels()).isBetween(50, 82);
              assertThat(seen.distance()).isCloseTo(Math.hypot(4, 0.95), within(1e-9));
            });
    CameraInput.Frame frame = world.robot("atrv1").camera("camera").capture(START);
    assertThat(green(at(frame, 160, 160))).as("darker than grass").isLessThan(60);
    assertThat(green(at(frame, 160, 170))).isGreaterThan(60);
  }

  private static MineSighting sighting(double pan, double tilt) {
    DeviceDescription camera = camera(DeviceKind.CAMERA, MountPose.MIDDLE).mountedOn("head");
    World world =
        World.of(
            field(1)
                .with(new MineDescription("mine", 34, 20))
                .with(
                    ugv("atrv1")
                        .with(
                            new DeviceDescription(
                                DeviceKind.PAN_TILT, "head", MountPose.at(0, 0, 1)))
                        .with(camera)),
            START);
    world.robot("atrv1").panTilt("head").point(START, pan, tilt);
    return world.groundTruth().minesInView("atrv1", "camera", after(0.01)).get(0);
  }

  @Test
  void panningLeftMovesThingsRightAndTiltingUpMovesThemDown() {
    assertThat(sighting(0, 0).column()).isCloseTo(160, within(0.6));
    assertThat(sighting(0.3, 0).column()).isCloseTo(160 + 160 * Math.tan(0.3), within(1.5));
    assertThat(sighting(-0.3, 0).column()).isCloseTo(160 - 160 * Math.tan(0.3), within(1.5));
    double below = Math.atan2(0.96, 4);
    assertThat(sighting(0, 0.2).row()).isCloseTo(120 + 160 * Math.tan(below + 0.2), within(2.0));
    assertThat(sighting(0, -0.2).row()).isCloseTo(120 + 160 * Math.tan(below - 0.2), within(2.0));
    assertThat(sighting(0, -0.2).column()).isCloseTo(160, within(0.6));
  }

  /** From 10 m above, 3 m ahead is 48 rows above the middle and 2 m to the left 32 columns left. */
  @Test
  void lookingDownAheadIsUpAndLeftIsLeft() {
    DeviceDescription down =
        camera(DeviceKind.CAMERA, new MountPose(0, 0, 10.05, 0, Math.PI / 2, 0));
    World world = World.of(with(field(1).with(new MineDescription("mine", 33, 22)), down), START);
    assertThat(world.groundTruth().minesInView("atrv1", "camera", START))
        .singleElement()
        .satisfies(
            seen -> {
              assertThat(seen.column()).isCloseTo(128, within(0.6));
              assertThat(seen.row()).isCloseTo(72, within(0.6));
              // π (0.16 m × 16 pixels per metre)² are 20.6 pixels, the sides make it more.
              assertThat(seen.pixels()).isBetween(16, 26);
            });
  }

  @Test
  void whatStandsInFrontHidesWhatIsBehind() {
    PlanarShape wall =
        new Polygon(
            List.of(
                new Vertex(32, 15),
                new Vertex(32.2, 15),
                new Vertex(32.2, 25),
                new Vertex(32, 25)));
    WorldDescription world =
        field(1)
            .with(new MineDescription("behind", 34, 20))
            .with(new MineDescription("before", 31.5, 20))
            .with(magenta(wall, 1.5));
    World hidden = World.of(with(world, camera(DeviceKind.CAMERA, MountPose.at(0, 0, 1))), START);
    assertThat(hidden.groundTruth().minesInView("atrv1", "camera", START))
        .extracting(MineSighting::mine)
        .containsExactly("before");
    CameraInput.Frame frame = hidden.robot("atrv1").camera("camera").capture(START);
    assertThat(isMagenta(frame, 160, 150)).isTrue();
    assertThat(isMagenta(frame, 160, 78)).as("above its top, 0.5 m at 2 m: row 80").isFalse();
    assertThat(isMagenta(frame, 160, 82)).isTrue();
  }

  @Test
  void otherRobotsAreSeenAndTheOwnMastIsNot() {
    WorldDescription world =
        field(1).with(new VehicleDescription("two", VehicleType.UGV, 35, 20, Math.PI / 2));
    CameraInput.Frame frame = look(world, DeviceKind.CAMERA);
    // Its red side is 0.32 m nearer than its middle, 0.12 m to 0.41 m up: rows 140.2 to 150.1.
    int side = at(frame, 160, 145);
    assertThat(red(side)).isGreaterThan(2 * green(side));
    int ground = at(frame, 160, 170);
    assertThat(green(ground)).isGreaterThan(red(ground));
  }

  /**
   * A metre farther east everything on the ground is 16 rows farther down, as 10 m of height go.
   */
  @Test
  void thePatternOfTheGroundStaysWhereItIs() {
    MountPose above = new MountPose(8, 0, 10, 0, Math.PI / 2, 0);
    CameraInput.Frame[] frames = new CameraInput.Frame[2];
    for (int i = 0; i < 2; i++) {
      VehicleDescription robot =
          new VehicleDescription("atrv1", VehicleType.UGV, 30 + i, 20, 0)
              .with(camera(DeviceKind.CAMERA, above));
      frames[i] =
          World.of(field(1).with(robot), START).robot("atrv1").camera("camera").capture(START);
    }
    int same = 0;
    int likeWithoutShift = 0;
    for (int row = 0; row < 200; row++) {
      for (int column = 0; column < 320; column++) {
        same += at(frames[0], column, row) == at(frames[1], column, row + 16) ? 1 : 0;
        likeWithoutShift += at(frames[0], column, row) == at(frames[1], column, row) ? 1 : 0;
      }
    }
    // All but those that rounding takes to the next piece of the pattern.
    assertThat(same / 64_000.0).isGreaterThan(0.95);
    assertThat(likeWithoutShift / 64_000.0).isLessThan(0.3);
  }

  /** By day the ground is 10 K above the air, dry places more, and a mine by its contrast. */
  @Test
  void heatDistinguishesMinesFromSoil() {
    for (double contrast : new double[] {4, -3}) {
      MineDescription mine =
          new MineDescription("mine", 34, 20, 0.16, 0.1, contrast, 0, SourceLocation.CODE);
      CameraInput.Frame frame = look(field(1).with(mine), DeviceKind.THERMAL);
      double ground = 0;
      for (int column = 130; column < 190; column++) {
        ground += at(frame, column, 175) / 60.0;
      }
      double air = 29_315;
      assertThat(ground).as("ground").isCloseTo(air + 1000, within(300.0));
      assertThat(at(frame, 160, 159) - ground)
          .as("a mine of %f K", contrast)
          .isCloseTo(100 * contrast, within(120.0));
      assertThat((double) at(frame, 160, 20)).as("sky").isLessThan(air - 800);
    }
  }

  /**
   * Of 76 800 pixels σ is known to 0.3 %; rounding to whole samples adds a twelfth to its square.
   */
  @Test
  void pixelsHaveWhiteNoise() {
    assertThat(noise(DeviceKind.THERMAL, 0.08, 0)).isCloseTo(8, within(0.16));
    for (int shift = 0; shift <= 16; shift += 8) {
      assertThat(noise(DeviceKind.CAMERA, 3, shift))
          .isCloseTo(Math.sqrt(9 + 1 / 12.0), within(0.06));
    }
  }

  /** σ of one pixel, from the difference of two pictures of what does not move. */
  private static double noise(DeviceKind kind, double whiteSigma, int shift) {
    DeviceDescription camera =
        camera(kind, new MountPose(8, 0, 10, 0, Math.PI / 2, 0))
            .with("white_noise_sigma", whiteSigma);
    CameraInput view = World.of(with(field(1), camera), START).robot("atrv1").camera("camera");
    int[] one = view.capture(START).samples();
    int[] other = view.capture(after(1)).samples();
    double[] differences = new double[one.length];
    int mask = kind == DeviceKind.THERMAL ? -1 : 0xFF;
    for (int i = 0; i < one.length; i++) {
      differences[i] = (one[i] >> shift & mask) - (other[i] >> shift & mask);
    }
    assertThat(Statistics.mean(differences)).isCloseTo(0, within(whiteSigma * 100 / 277 * 4));
    assertThat(Statistics.correlation(differences, 1)).isCloseTo(0, within(4 / 277.0));
    return Statistics.sigma(differences) / Math.sqrt(2);
  }

  @Test
  void shadowsFallAwayFromTheSun() {
    // The sun stands 0.8 rad high in the direction of −2.4 rad, so the shadow of 2 m is 1.94 m long
    // and falls towards 0.74 rad.
    DeviceDescription down = camera(DeviceKind.CAMERA, new MountPose(5, 0, 10, 0, Math.PI / 2, 0));
    CameraInput.Frame[] frames = new CameraInput.Frame[2];
    WorldDescription post = field(1).with(magenta(new Disc(35, 20, 0.1), 2));
    for (int i = 0; i < 2; i++) {
      WorldDescription world = with(i == 0 ? post : field(1), down);
      frames[i] = World.of(world, START).robot("atrv1").camera("camera").capture(START);
    }
    for (double away : new double[] {0.6, 1.2, 1.8}) {
      int left = (int) Math.round(16 * away * Math.sin(0.74));
      int ahead = (int) Math.round(16 * away * Math.cos(0.74));
      double shade = green(at(frames[0], 160 - left, 120 - ahead));
      assertThat(shade / green(at(frames[1], 160 - left, 120 - ahead))).isBetween(0.55, 0.75);
      assertThat(at(frames[0], 160 + left, 120 + ahead))
          .as("towards the sun")
          .isEqualTo(at(frames[1], 160 + left, 120 + ahead));
    }
    int left = (int) Math.round(16 * 2.2 * Math.sin(0.74));
    int ahead = (int) Math.round(16 * 2.2 * Math.cos(0.74));
    assertThat(at(frames[0], 160 - left, 120 - ahead))
        .as("beyond its end")
        .isEqualTo(at(frames[1], 160 - left, 120 - ahead));
  }
}
