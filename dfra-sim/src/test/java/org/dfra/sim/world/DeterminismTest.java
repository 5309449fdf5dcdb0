package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.sim.world.Worlds.START;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Random;
import java.util.TreeMap;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.description.WorldDescription.GroundDescription;
import org.dfra.sim.world.file.WorldXml;
import org.junit.jupiter.api.Test;

/** Runs the field that is shipped for 60 s under the same commands and digests all that is seen. */
class DeterminismTest {

  private static final int MILLIS = 60_000;
  private static final Path ROOT =
      Path.of(Objects.requireNonNull(System.getProperty("dfra.root"), "dfra.root is not set"));

  private static WorldDescription field() {
    WorldDescription field = WorldXml.read(ROOT.resolve("config/worlds/field.xml"), name -> null);
    GroundDescription ground = field.ground();
    return field.withGround(
        new GroundDescription(ground.sizeEast(), ground.sizeNorth(), 0.03, ground.place()));
  }

  /** A thing done at a time: a command, or a look that is digested under its device's name. */
  private record Act(int millis, Runnable body) {}

  /** A run of one world: what is done, and the digest of what each device saw. */
  private static final class Run {
    final World world;
    final List<Act> acts = new ArrayList<>();
    final Map<String, MessageDigest> digests = new TreeMap<>();

    Run(WorldDescription description) {
      world = World.of(description, START);
      for (SimulatedRobot robot : world.robots()) {
        commands(robot);
        robot.description().devices().forEach(device -> looks(robot, device));
      }
    }

    private void commands(SimulatedRobot robot) {
      VehicleDescription vehicle = robot.description();
      for (int millis = 3; millis < MILLIS; millis += 1700) {
        Instant time = START.plusMillis(millis);
        int nth = millis / 1700;
        if (vehicle.device("drive").isPresent()) {
          acts.add(
              new Act(
                  millis,
                  () -> {
                    robot.drivetrain("drive").drive(time, 0.8, nth % 5 * 0.2 - 0.4, 1, 2);
                    robot.drivetrain("drive").brake(time, nth % 7 == 6);
                    robot.panTilt("pan_tilt").point(time, nth % 3 * 0.4 - 0.4, -0.1);
                  }));
        } else {
          acts.add(
              new Act(
                  millis,
                  () -> {
                    robot.multicopter("flight").rotors(time, true);
                    robot.multicopter("flight").fly(time, 10 + nth, 20, 6, 3);
                  }));
        }
      }
    }

    private void looks(SimulatedRobot robot, DeviceDescription device) {
      int period =
          switch (device.kind()) {
            case GPS -> 1000;
            case CAMERA, THERMAL -> 10_000;
            default -> 100;
          };
      for (int millis = 0; millis <= MILLIS; millis += period) {
        Instant time = START.plusMillis(millis);
        acts.add(new Act(millis, () -> digest(device.name(), robot, see(robot, device, time))));
      }
    }

    private static byte[] see(SimulatedRobot robot, DeviceDescription device, Instant time) {
      String name = device.name();
      return switch (device.kind()) {
        case GPS -> bytes(robot.antenna(name).at(time));
        case LASER -> {
          double[] distances = new double[181];
          robot.laser(name).measure(time, -Math.PI / 2, Math.PI / 180, 30, distances);
          ByteBuffer bytes = ByteBuffer.allocate(8 * distances.length);
          bytes.asDoubleBuffer().put(distances);
          yield bytes.array();
        }
        case DRIVE -> bytes(robot.drivetrain(name).travel(time));
        case GYRO -> bytes(robot.gyro(name).rate(time));
        case CAMERA, THERMAL -> {
          int[] samples = robot.camera(name).capture(time).samples();
          ByteBuffer bytes = ByteBuffer.allocate(4 * samples.length);
          bytes.asIntBuffer().put(samples);
          yield bytes.array();
        }
        case BATTERY -> bytes(robot.battery(name).at(time));
        case FLIGHT -> bytes(robot.multicopter(name).at(time));
        case PAN_TILT -> new byte[0];
      };
    }

    private static byte[] bytes(Object value) {
      return value.toString().getBytes(StandardCharsets.UTF_8);
    }

    private void digest(String device, SimulatedRobot robot, byte[] seen) {
      digests.computeIfAbsent(robot.name() + "/" + device, key -> sha256()).update(seen);
    }

    Map<String, String> result() {
      acts.forEach(act -> act.body().run());
      Map<String, String> result = new TreeMap<>();
      digests.forEach((key, digest) -> result.put(key, HexFormat.of().formatHex(digest.digest())));
      result.put("collisions", world.groundTruth().collisions().toString());
      result.put("late", Long.toString(world.groundTruth().lateCommands()));
      return result;
    }
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }

  /** By time; those of one time in another order for each shuffle, as threads might come. */
  private static Run shuffled(WorldDescription description, long shuffle) {
    Run run = new Run(description);
    Collections.shuffle(run.acts, new Random(shuffle));
    run.acts.sort(Comparator.comparingInt(Act::millis));
    return run;
  }

  @Test
  void sameSeedSameViewsHoweverItIsAsked() {
    Map<String, String> first = shuffled(field(), 1).result();
    assertThat(first).hasSizeGreaterThan(20).containsEntry("late", "0");

    assertThat(shuffled(field(), 2).result()).as("in another order").isEqualTo(first);

    Run nosy = shuffled(field(), 3);
    for (int millis = 0; millis < MILLIS; millis += 7) { // somebody else looks in between
      Instant time = START.plusMillis(millis);
      nosy.acts.add(
          new Act(
              millis,
              () -> {
                nosy.world.robot("atrv1").antenna("gps_front").at(time);
                double unused = nosy.world.robot("atrv2").gyro("gyro").rate(time);
                nosy.world.robot("atrv1").laser("laser").measure(time, 0, 0.1, 9, new double[3]);
                nosy.world.groundTruth().poses(time);
              }));
    }
    nosy.acts.sort(Comparator.comparingInt(Act::millis));
    assertThat(nosy.result()).as("asked more often").isEqualTo(first);
  }

  @Test
  void anotherSeedIsAnotherWorld() {
    Map<String, String> first = shuffled(field(), 1).result();
    Map<String, String> other = shuffled(field().withSeed(2), 1).result();
    for (String device : first.keySet()) {
      if (!List.of("late", "collisions").contains(device)
          && !device.endsWith("pan_tilt")
          && !device.endsWith("battery")) {
        assertThat(other.get(device)).as(device).isNotEqualTo(first.get(device));
      }
    }
  }

  /** Each thread asks for its own robot, as fast as it can; nothing is commanded. */
  @Test
  void anyThreadMayAsk() throws InterruptedException {
    World world = World.of(field(), START);
    List<Throwable> failures = Collections.synchronizedList(new ArrayList<>());
    List<Thread> threads = new ArrayList<>();
    for (SimulatedRobot robot : world.robots()) {
      Thread thread =
          new Thread(
              () -> {
                for (int millis = 0; millis <= 5000; millis += 50) {
                  Instant time = START.plusMillis(millis);
                  robot.description().devices().forEach(device -> Run.see(robot, device, time));
                }
              });
      thread.setUncaughtExceptionHandler((t, failure) -> failures.add(failure));
      threads.add(thread);
      thread.start();
    }
    for (Thread thread : threads) {
      thread.join();
    }
    assertThat(failures).isEmpty();
    World alone = World.of(field(), START);
    Instant end = START.plusSeconds(5);
    for (SimulatedRobot robot : world.robots()) {
      for (DeviceDescription device : robot.description().devices()) {
        assertThat(Run.see(robot, device, end))
            .as("%s/%s", robot.name(), device.name())
            .isEqualTo(Run.see(alone.robot(robot.name()), device, end));
      }
    }
  }

  /** A device more on one robot leaves all the others as they were. */
  @Test
  void aDeviceMoreChangesNoOther() {
    WorldDescription field = field();
    List<VehicleDescription> more = new ArrayList<>();
    for (VehicleDescription vehicle : field.vehicles()) {
      more.add(
          vehicle.name().equals("atrv1")
              ? vehicle.with(Worlds.device(DeviceKind.GPS, "gps_third"))
              : vehicle);
    }
    WorldDescription with =
        new WorldDescription(
            field.name(),
            field.seed(),
            field.datum(),
            field.ground(),
            field.weather(),
            field.obstacles(),
            field.mines(),
            field.region(),
            more,
            field.place());
    Map<String, String> result = shuffled(with, 1).result();
    assertThat(result.remove("atrv1/gps_third")).isNotNull();
    assertThat(result).isEqualTo(shuffled(field, 1).result());
  }
}
