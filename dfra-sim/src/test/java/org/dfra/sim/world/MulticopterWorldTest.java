package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.device;
import static org.dfra.sim.world.Worlds.field;

import org.dfra.core.config.SourceLocation;
import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.physics.MulticopterPhysics;
import org.dfra.sim.world.GroundTruth.Collision;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription.ObstacleDescription;
import org.dfra.sim.world.description.WorldDescription.WeatherDescription;
import org.dfra.sim.world.shape.PlanarShape.Disc;
import org.junit.jupiter.api.Test;

/** The multicopter stands at (10, 20) and its nose points east. */
class MulticopterWorldTest {

  private static final VehicleDescription UAV =
      new VehicleDescription("uav1", VehicleType.UAV, 10, 20, 0);

  private static World world(DeviceDescription... devices) {
    VehicleDescription uav = UAV;
    for (DeviceDescription one : devices) {
      uav = uav.with(one);
    }
    return World.of(field(1).with(uav), START);
  }

  private static DeviceDescription calm() {
    return device(DeviceKind.FLIGHT, "flight").with("gust_response", 0);
  }

  private static MulticopterPhysics flight(World world) {
    return world.robot("uav1").multicopter("flight");
  }

  private static double off(
      MulticopterPhysics.MulticopterState at, double east, double north, double up) {
    return Math.hypot(Math.hypot(at.east() - east, at.north() - north), at.up() - up);
  }

  @Test
  void doesNothingWhileItsRotorsStand() {
    World world = world(calm());
    flight(world).fly(START, 30, 20, 5, 3);
    MulticopterPhysics.MulticopterState at = flight(world).at(after(5));
    assertThat(off(at, 10, 20, 0)).isZero();
    assertThat(at.rotorsTurning()).isFalse();
  }

  @Test
  void takesOffFliesAndLands() {
    World world = world(calm());
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    assertThat(flight.at(after(1)).rotorsTurning()).isTrue();
    assertThat(flight.at(after(1)).up()).isZero();
    flight.fly(after(1), 10, 20, 6, 3);
    assertThat(off(flight.at(after(10)), 10, 20, 6)).isLessThan(0.01);
    flight.fly(after(10), 40, 20, 6, 5);
    MulticopterPhysics.MulticopterState onItsWay = flight.at(after(13));
    assertThat(onItsWay.eastward()).isCloseTo(5, within(0.01));
    assertThat(onItsWay.north()).isCloseTo(20, within(1e-9));
    assertThat(off(flight.at(after(25)), 40, 20, 6)).isLessThan(0.01);
    flight.fly(after(25), 40, 20, 0, 3);
    MulticopterPhysics.MulticopterState landed = flight.at(after(40));
    assertThat(landed.up()).isZero();
    assertThat(landed.upward()).isZero();
    assertThat(landed.rotorsTurning()).isTrue();
    flight.rotors(after(40), false);
    assertThat(flight.at(after(41)).rotorsTurning()).isFalse();
  }

  @Test
  void keepsToItsLimits() {
    World world =
        world(
            calm()
                .with("max_speed", 4)
                .with("max_acceleration", 2)
                .with("max_climb", 1.5)
                .with("max_descent", 1));
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    flight.fly(after(0.1), 50, 20, 10, 100);
    MulticopterPhysics.MulticopterState before = flight.at(after(0.1));
    for (int i = 11; i < 6000; i++) {
      if (i == 3000) {
        flight.fly(after(i * 0.01), 10, 30, 2, 100);
      }
      MulticopterPhysics.MulticopterState at = flight.at(after(i * 0.01));
      assertThat(Math.hypot(at.eastward(), at.northward())).isLessThan(4.001);
      assertThat(at.upward()).isBetween(-1.001, 1.501);
      double change =
          Math.hypot(at.eastward() - before.eastward(), at.northward() - before.northward());
      assertThat(change).isLessThan(0.02001);
      assertThat(Math.abs(at.upward() - before.upward())).isLessThan(0.02001);
      before = at;
    }
    assertThat(off(before, 10, 30, 2)).isLessThan(0.01);
  }

  /** Climbing while it flies it stays on the line from start to end, within some centimetres. */
  @Test
  void fliesInAStraightLine() {
    World world = world(calm());
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    flight.fly(after(0.1), 34, 28, 8, 4);
    double length = Math.sqrt(24 * 24 + 8 * 8 + 8 * 8);
    for (int i = 0; i < 200; i++) {
      MulticopterPhysics.MulticopterState at = flight.at(after(0.1 * i));
      double along = ((at.east() - 10) * 24 + (at.north() - 20) * 8 + at.up() * 8) / length;
      double share = along / length;
      assertThat(off(at, 10 + share * 24, 20 + share * 8, share * 8)).isLessThan(0.05);
    }
  }

  @Test
  void turnsItsNoseWhereItFlies() {
    World world = world(calm().with("max_yaw_rate", 1));
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    flight.fly(after(0.1), 10, 20, 5, 3);
    flight.fly(after(10), 10, 38, 5, 4);
    assertThat(flight.at(after(10)).yaw()).isZero();
    assertThat(flight.at(after(11)).yaw()).as("by 1 rad/s at most").isBetween(0.5, 1.0);
    assertThat(flight.at(after(14)).yaw()).isCloseTo(Math.PI / 2, within(1e-3));
  }

  /** Gusts move it about while it hovers, by less than half a metre, and not on the ground. */
  @Test
  void gustsPushItInTheAir() {
    World world = world(device(DeviceKind.FLIGHT, "flight"));
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    assertThat(off(flight.at(after(5)), 10, 20, 0)).isZero();
    flight.fly(after(5), 10, 20, 5, 3);
    double farthest = 0;
    for (int i = 15; i < 315; i++) {
      farthest = Math.max(farthest, off(flight.at(after(i)), 10, 20, 5));
    }
    assertThat(farthest).isBetween(0.02, 0.5);
  }

  /** Hovering in a wind of 6 m/s it flies at 6 m/s through the air, which takes 12 W s/m. */
  @Test
  void hoveringInTheWindCostsPower() {
    double[] powers = new double[2];
    for (int i = 0; i < 2; i++) {
      WeatherDescription fair = WeatherDescription.FAIR;
      WeatherDescription weather =
          new WeatherDescription(
              fair.temperature(), fair.groundWarming(), 0, 1, 6 * i, 2.5, 0, SourceLocation.CODE);
      VehicleDescription uav = UAV.with(calm()).with(device(DeviceKind.BATTERY, "battery"));
      World world = World.of(field(1).withWeather(weather).with(uav), START);
      flight(world).rotors(START, true);
      flight(world).fly(after(0.1), 10, 20, 5, 3);
      BatteryPhysics.Charge charge = world.robot("uav1").battery("battery").at(after(20));
      powers[i] = charge.voltage() * charge.current();
    }
    assertThat(powers[0]).isCloseTo(12 + 190, within(0.1));
    assertThat(powers[1] - powers[0]).isCloseTo(12 * 6, within(0.1));
  }

  @Test
  void cannotStopItsRotorsInTheAir() {
    World world = world(calm());
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    flight.fly(after(0.1), 10, 20, 5, 3);
    flight.rotors(after(8), false);
    assertThat(flight.at(after(12)).up()).isCloseTo(5, within(0.01));
    assertThat(flight.at(after(12)).rotorsTurning()).isTrue();
  }

  @Test
  void landsWithAnEmptyBattery() {
    World world = world(calm(), device(DeviceKind.BATTERY, "battery").with("capacity", 0.15));
    MulticopterPhysics flight = flight(world);
    flight.rotors(START, true);
    flight.fly(after(0.1), 10, 20, 5, 3);
    assertThat(flight.at(after(20)).up()).isCloseTo(5, within(0.01));
    MulticopterPhysics.MulticopterState later = flight.at(after(120));
    assertThat(later.up()).isZero();
    assertThat(later.rotorsTurning()).isFalse();
    assertThat(world.robot("uav1").battery("battery").at(after(120)).remaining()).isZero();
  }

  @Test
  void stopsAtAMastAndFliesOverAPost() {
    World world =
        World.of(
            field(1)
                .with(new ObstacleDescription("post", new Disc(15, 20, 0.1), 1.5))
                .with(new ObstacleDescription("mast", new Disc(20, 20, 0.1), 12))
                .with(UAV.with(calm())),
            START);
    flight(world).rotors(START, true);
    flight(world).fly(after(0.1), 10, 20, 5, 3);
    flight(world).fly(after(8), 30, 20, 5, 3);
    MulticopterPhysics.MulticopterState at = flight(world).at(after(20));
    assertThat(at.east()).isBetween(19.5, 19.6001);
    assertThat(world.groundTruth().collisions())
        .extracting(Collision::other)
        .containsExactly("mast");
  }

  @Test
  void refusesNoPlace() {
    MulticopterPhysics flight = flight(world(calm()));
    assertThatThrownBy(() -> flight.fly(START, Double.NaN, 0, 1, 1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("NaN");
    assertThatThrownBy(() -> flight.fly(START, 1, 0, 1, 0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("a speed above 0");
  }
}
