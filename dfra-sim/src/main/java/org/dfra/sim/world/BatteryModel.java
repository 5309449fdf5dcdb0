package org.dfra.sim.world;

import java.util.Optional;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.jspecify.annotations.Nullable;

/**
 * A battery: a charge, a voltage that falls with it, and a resistance inside. Confined to the
 * world's monitor.
 */
final class BatteryModel {

  static final int VOLTAGE = 0;
  static final int CURRENT = 1;
  static final int REMAINING = 2;
  static final int WIDTH = 3;

  private static final double SECONDS_PER_HOUR = 3600;

  /**
   * Remaining charge, and the voltage at that charge as a fraction from empty to full: of lithium
   * polymer, which falls steeply at the end. That of lead acid, without load, is linear.
   */
  private static final double[][] LITHIUM = {
    {0, 0}, {0.05, 0.25}, {0.15, 0.45}, {0.5, 0.65}, {0.9, 0.88}, {1, 1}
  };

  private static final double[][] LEAD = {{0, 0}, {1, 1}};

  final int offset;
  final double motion;
  final double turning;
  final double hover;

  private final double[][] curve;
  private final double idle;
  private final double capacity; // ampere seconds
  private final double full;
  private final double empty;
  private final double resistance;
  private double charge; // ampere seconds
  private double voltage;
  private double current;

  private BatteryModel(VehicleDescription vehicle, DeviceDescription device, int offset) {
    this.offset = offset;
    this.motion = device.parameter("power_per_speed", vehicle.type());
    this.turning = device.parameter("power_per_yaw_rate", vehicle.type());
    this.hover = device.parameter("hover_power", vehicle.type());
    this.curve = vehicle.type() == VehicleType.UAV ? LITHIUM : LEAD;
    this.idle = device.parameter("idle_power", vehicle.type());
    this.capacity = device.parameter("capacity", vehicle.type()) * SECONDS_PER_HOUR;
    this.full = device.parameter("full_voltage", vehicle.type());
    this.empty = device.parameter("empty_voltage", vehicle.type());
    this.resistance = device.parameter("internal_resistance", vehicle.type());
    this.charge = device.parameter("initial_charge", vehicle.type()) * capacity;
    load(idle);
  }

  /** The battery of a robot; null without a description: it then never discharges. */
  static @Nullable BatteryModel of(VehicleDescription vehicle, StateLayout slots) {
    Optional<DeviceDescription> device = vehicle.device(DeviceKind.BATTERY);
    return device.isEmpty() ? null : new BatteryModel(vehicle, device.get(), slots.allocate(WIDTH));
  }

  boolean isEmpty() {
    return charge <= 0;
  }

  /**
   * Supplies power for a step.
   *
   * @param power watts in addition to those of a stationary robot
   */
  void drain(double power) {
    load(isEmpty() ? 0 : idle + power);
    charge = Math.max(0, charge - current * World.STEP_SECONDS);
  }

  void write(double[] row) {
    row[offset + VOLTAGE] = voltage;
    row[offset + CURRENT] = current;
    row[offset + REMAINING] = charge / capacity;
  }

  /** Finds the voltage V and current I at which V·I is the power: V = U − R·I. */
  private void load(double power) {
    double open = openVoltage(charge / capacity);
    double root = open * open - 4 * power * resistance;
    boolean isEnough = root >= 0; // otherwise the maximum power that it can supply
    voltage = isEnough ? (open + Math.sqrt(root)) / 2 : open / 2;
    current = isEnough ? power / voltage : open / (2 * resistance);
  }

  private double openVoltage(double remaining) {
    int i = 1;
    while (i < curve.length - 1 && remaining > curve[i][0]) {
      i++;
    }
    double[] a = curve[i - 1];
    double[] b = curve[i];
    double part = a[1] + (b[1] - a[1]) * (remaining - a[0]) / (b[0] - a[0]);
    return empty + (full - empty) * part;
  }
}
