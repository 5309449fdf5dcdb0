package org.dfra.sim.world;

import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.world.description.DeviceDescription;
import org.dfra.sim.world.description.DeviceDescription.MountPose;
import org.dfra.sim.world.description.DeviceKind;
import org.dfra.sim.world.description.VehicleDescription;
import org.dfra.sim.world.description.VehicleDescription.VehicleType;
import org.dfra.sim.world.description.WorldDescription;

/** Worlds and robots as the tests want them. */
final class Worlds {

  static final Instant START = Instant.parse("2026-04-01T10:00:00Z");

  private static final GeoPosition DATUM = new GeoPosition(48, 11, 520);

  private Worlds() {}

  /** An empty field of 60 × 40 m. */
  static WorldDescription field(long seed) {
    return new WorldDescription("field", seed, DATUM, 60, 40);
  }

  /** So many seconds after the start. */
  static Instant after(double seconds) {
    return START.plus(Duration.ofNanos(Math.round(seconds * 1e9)));
  }

  /** A UGV in the middle of the field that heads east. */
  static VehicleDescription ugv(String name) {
    return new VehicleDescription(name, VehicleType.UGV, 30, 20, 0);
  }

  static DeviceDescription device(DeviceKind kind, String name) {
    return new DeviceDescription(kind, name, MountPose.MIDDLE);
  }

  /** A drive without slip, error and limit. */
  static DeviceDescription perfectDrive() {
    DeviceDescription drive = device(DeviceKind.DRIVE, "drive");
    for (Map.Entry<String, Double> one :
        Map.of(
                "slip", 0.0,
                "slip_sigma", 0.0,
                "yaw_slip", 0.0,
                "yaw_slip_sigma", 0.0,
                "encoder_scale_sigma", 0.0,
                "max_wheel_speed", 20.0,
                "max_acceleration", 100.0)
            .entrySet()) {
      drive = drive.with(one.getKey(), one.getValue());
    }
    return drive;
  }
}
