package org.dfra.cli.noise;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dfra.cli.noise.NoiseStudy.NoiseParameter;
import org.dfra.core.config.RobotXml;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.robot.LocalRobot;
import org.dfra.core.state.StateStore;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.module.Module;
import org.dfra.sim.run.Simulation;
import org.dfra.sim.time.LockStep;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.WorldDescription;
import org.dfra.sim.world.file.WorldXml;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * The procedures of {@code docs/reference/sensor-noise.md}, against simulated devices whose noise
 * is known. The tolerances are three standard deviations of what an hour can show, or more.
 */
@Timeout(300)
class NoiseStudyTest {

  private static final Path CONFIG = Path.of(System.getProperty("dfra.root"), "config");
  private static final Duration HOUR = Duration.ofHours(1);

  /** Hours for which two receivers are at rest. */
  private static final int HOURS = Boolean.getBoolean("dfra.full") ? 3 : 1;

  /** What the modules of a standing robot amount to, by figure; a module each. */
  private static Map<String, List<NoiseParameter>> measured(
      long seed, Duration time, List<String> modules) throws Exception {
    LockStep clock = new LockStep(Instant.parse("2026-11-21T12:00:00Z"));
    Map<String, List<NoiseParameter>> figures = new HashMap<>();
    WorldDescription field = WorldXml.read(CONFIG.resolve("worlds/raster.xml"), name -> null);
    try (Simulation world = Simulation.inLockStep(alone(field.withSeed(seed), modules), clock);
        InMemoryModuleDirectory directory = new InMemoryModuleDirectory(clock)) {
      world.start();
      Map<String, String> links = new HashMap<>();
      world.endpoints().forEach(line -> links.put(line.linkVariable(), line.link()));
      try (LocalRobot robot =
          new LocalRobot(
              RobotXml.read(CONFIG.resolve("teams/raster/atrv1.xml"), links::get),
              directory,
              clock,
              path -> StateStore.inMemory())) {
        Map<String, NoiseStudy> studies = new HashMap<>();
        for (String name : modules) {
          ModuleImpl module = (ModuleImpl) robot.module(name, Module.class).orElseThrow();
          module.start();
          var unused =
              module.subscribe(
                  delivery -> {
                    if (delivery.event() instanceof ModuleEvent.NewReading fresh) {
                      Reading reading = fresh.reading();
                      studies
                          .computeIfAbsent(name, key -> NoiseStudy.of(reading).orElseThrow())
                          .add(reading);
                    }
                  },
                  DeliveryPolicy.keepLast(1000));
        }
        clock.advance(time);
        studies.forEach((name, study) -> figures.put(name, study.parameters()));
      }
    }
    System.out.println("seed " + seed + ": " + figures);
    return figures;
  }

  /** A world with atrv1 and those of its devices: the others would only take time. */
  static WorldDescription alone(WorldDescription whole, List<String> devices) {
    VehicleDescription robot = whole.vehicle("atrv1");
    VehicleDescription alone =
        new VehicleDescription(
            robot.name(),
            robot.type(),
            robot.east(),
            robot.north(),
            robot.yaw(),
            robot.length(),
            robot.width(),
            robot.height(),
            robot.devices().stream().filter(each -> devices.contains(each.name())).toList(),
            robot.place());
    return new WorldDescription(
        whole.name(),
        whole.seed(),
        whole.datum(),
        whole.ground(),
        whole.weather(),
        whole.obstacles(),
        whole.mines(),
        whole.region(),
        List.of(alone),
        whole.place());
  }

  private static Map<String, Double> byName(List<NoiseParameter> figures) {
    return figures.stream().collect(Collectors.toMap(NoiseParameter::name, NoiseParameter::value));
  }

  @Test
  void anHourAtRestShowsTheErrorsOfAReceiver() throws Exception {
    List<Double> biases = new ArrayList<>();
    List<Double> times = new ArrayList<>();
    for (long seed = 1; seed <= HOURS; seed++) {
      for (List<NoiseParameter> each :
          measured(seed, HOUR, List.of("gps_front", "gps_rear")).values()) {
        Map<String, Double> figures = byName(each);
        // sqrt(0.6² + 1.5² (1 - exp(-1/200))) = 0.609, of 3600 differences
        assertThat(figures.get("gps_white_noise_sigma")).isBetween(0.57, 0.65);
        biases.add(figures.get("gps_bias_sigma"));
        times.add(figures.get("gps_bias_correlation_time"));
      }
    }
    // an hour has 9 independent values of a bias of 200 s, so each figure may be off by a third
    assertThat(mean(biases)).as("%s", biases).isBetween(0.9, 2.0);
    assertThat(mean(times)).as("%s", times).isBetween(80.0, 400.0);
  }

  @Test
  void aGyroShowsItsNoiseAlsoWhereItsDriftIsGreaterByFar() throws Exception {
    Map<String, Double> figures =
        byName(measured(4, Duration.ofMinutes(20), List.of("gyro")).get("gyro"));
    assertThat(figures.get("gyro_noise_density")).isBetween(0.00027, 0.00033);
    assertThat(figures.get("gyro_bias_random_walk")).isBetween(0.00012, 0.00032);
    assertThat(figures.get("gyro_bias_sigma")).isBetween(0.0, 0.02);
  }

  @Test
  void aLaserShowsHowManyGhostsItSeesAndHowLongTheyLast() throws Exception {
    Map<String, Double> figures =
        byName(measured(5, Duration.ofMinutes(5), List.of("laser")).get("laser"));
    assertThat(figures.get("ghost_rate")).isBetween(0.2, 0.7);
    assertThat(figures.get("ghost_duration")).isBetween(0.1, 0.2);
    assertThat(figures.get("white_noise_sigma")).isBetween(0.008, 0.013);
  }

  @Test
  void saysThatNothingIsKnownYetOfTooFewReadings() {
    GpsNoiseStudy study = new GpsNoiseStudy();
    study.add(
        new GpsFix(GpsFix.Mode.NONE, null, Instant.EPOCH, 0, 0, 1, 0, 0)); // no position, no figure
    assertThat(study.readings()).isZero();
    assertThat(study.parameters()).allMatch(each -> Double.isNaN(each.value()));
  }

  private static double mean(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).average().orElseThrow();
  }
}
