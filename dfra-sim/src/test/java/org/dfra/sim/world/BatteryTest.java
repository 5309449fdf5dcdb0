package org.dfra.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dfra.sim.world.Worlds.START;
import static org.dfra.sim.world.Worlds.after;
import static org.dfra.sim.world.Worlds.device;
import static org.dfra.sim.world.Worlds.field;
import static org.dfra.sim.world.Worlds.perfectDrive;
import static org.dfra.sim.world.Worlds.ugv;

import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.junit.jupiter.api.Test;

class BatteryTest {

  private static final DeviceDescription BATTERY =
      device(DeviceKind.BATTERY, "battery")
          .with("capacity", 10)
          .with("full_voltage", 26)
          .with("empty_voltage", 20)
          .with("internal_resistance", 0.1)
          .with("idle_power", 50)
          .with("power_per_speed", 100)
          .with("power_per_yaw_rate", 40);

  private static World world(DeviceDescription battery) {
    return World.of(field(1).with(ugv("atrv1").with(perfectDrive()).with(battery)), START);
  }

  private static BatteryPhysics.Charge charge(World world, double seconds) {
    return world.robot("atrv1").battery("battery").at(after(seconds));
  }

  /** The current I of P watts satisfies P = (U − R I) I. */
  @Test
  void itsVoltageFallsWithItsLoad() {
    World world = world(BATTERY);
    BatteryPhysics.Charge idle = charge(world, 0);
    assertThat(idle.voltage() * idle.current()).isCloseTo(50, within(1e-9));
    assertThat(idle.voltage() + 0.1 * idle.current()).isCloseTo(26, within(1e-9));
    world.robot("atrv1").drivetrain("drive").drive(START, 0.8, 0.5, 1e9, 1e9);
    BatteryPhysics.Charge moving = charge(world, 1);
    assertThat(moving.voltage() * moving.current()).isCloseTo(50 + 80 + 20, within(1e-9));
    assertThat(moving.voltage()).isLessThan(idle.voltage() - 0.3);
  }

  /** 50 W at about 23 V draw 2.2 A, which empty 10 Ah in about 4.6 h. */
  @Test
  void whatItGivesIsGone() {
    World world = world(BATTERY.with("internal_resistance", 0));
    double drawn = 0;
    for (int minute = 0; minute < 60; minute++) {
      drawn += charge(world, 60 * minute).current() / 60;
    }
    assertThat(charge(world, 3600).remaining()).isCloseTo(1 - drawn / 10, within(1e-3));
    assertThat(charge(world, 3600).voltage()).isBetween(20.0, 26.0);
    assertThat(charge(world, 3600 * 4.2).remaining()).isBetween(0.0, 0.2);
    BatteryPhysics.Charge empty = charge(world, 3600 * 6);
    assertThat(empty.remaining()).isZero();
    assertThat(empty.current()).isZero();
    assertThat(empty.voltage()).isCloseTo(20, within(1e-9));
  }

  @Test
  void itsVoltageFallsSteadilyFromFullToEmpty() {
    double before = Double.POSITIVE_INFINITY;
    for (int percent = 100; percent >= 0; percent -= 5) {
      double voltage =
          charge(world(BATTERY.with("idle_power", 0).with("initial_charge", percent / 100.0)), 0)
              .voltage();
      assertThat(voltage).isLessThan(before);
      before = voltage;
    }
    assertThat(before).isEqualTo(20);
  }

  /** 26 V over 2 Ω give 84.5 W at most; asked for 500 W it gives these at half its voltage. */
  @Test
  void givesNoMoreThanItCan() {
    BatteryPhysics.Charge charge =
        charge(world(BATTERY.with("internal_resistance", 2).with("idle_power", 500)), 0);
    assertThat(charge.voltage()).isCloseTo(13, within(1e-9));
    assertThat(charge.current()).isCloseTo(6.5, within(1e-9));
  }
}
