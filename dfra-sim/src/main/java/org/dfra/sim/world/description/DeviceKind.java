package org.dfra.sim.world.description;

import java.util.List;
import java.util.Optional;

/** The kinds of device that a robot can carry, with the parameters of each. */
public enum DeviceKind {
  /** A satellite receiver; its mount is where its antenna is. */
  GPS(
      "gps",
      number("white", 0.6, 0, 100, "m", "σ of what is new with each position, east and north each"),
      number("bias", 1.5, 0, 100, "m", "σ of what changes slowly, east and north each"),
      number("bias_time", 200, 0.1, 1e6, "s", "correlation time of that"),
      number("vertical", 1.5, 0, 100, "", "how much larger both are upwards"),
      number("velocity", 0.05, 0, 100, "m/s", "σ of the velocity, east and north each"),
      number("outages", 0, 0, 3600, "", "times in an hour at which it loses all satellites"),
      number("outage_time", 20, 0.1, 3600, "s", "how long that lasts on average")),
  /** A range finder with a beam that rotates in its x-y plane. */
  LASER(
      "laser",
      number("white", 0.01, 0, 10, "m", "σ of each range"),
      number("miss", 0.002, 0, 1, "", "part of the beams that nothing comes back from"),
      number("reach", 10, 0.1, 1000, "m", "how far it sees what returns a tenth of its light"),
      number("ghosts", 0.5, 0, 100, "/s", "short false ranges from uneven terrain, in a second"),
      number("ghost_time", 0.15, 0.01, 10, "s", "how long one lasts on average"),
      number("ghost_width", 0.07, 0.001, 3, "rad", "how wide one is on average"),
      number("ghost_near", 0.6, 0, 1000, "m", "the nearest"),
      number("ghost_far", 5, 0, 1000, "m", "the farthest")),
  /** The wheels of a UGV with their motors and encoders. */
  DRIVE(
      "drive",
      number("effective_track", 0.75, 0.05, 10, "m", "how far apart the sides seem to be turning"),
      number("max_wheel_speed", 1.2, 0.01, 20, "m/s", "the fastest that a side goes"),
      number("max_acceleration", 8, 0.01, 100, "m/s²", "the most that a side changes its speed by"),
      number("brake", 8, 0.01, 100, "m/s²", "how the brakes slow a side down"),
      number("slip", 0.02, -0.5, 0.9, "", "part of the wheels' way that the body lags behind"),
      number("slip_noise", 0.02, 0, 0.5, "", "σ of that as it changes"),
      number("turn_slip", 0.05, -0.5, 0.9, "", "part of the wheels' turn that the body lags"),
      number("turn_slip_noise", 0.05, 0, 0.5, "", "σ of that as it changes"),
      number("slip_time", 2, 0.01, 1e6, "s", "correlation time of both"),
      number("encoder_noise", 0.005, 0, 0.2, "", "σ of each side's scale, drawn once"),
      number("encoder_left", 0, -0.5, 0.5, "", "what the left side measures too much, besides"),
      number("encoder_right", 0, -0.5, 0.5, "", "what the right side measures too much, besides")),
  /** A rate gyro; it measures about its z axis. */
  GYRO(
      "gyro",
      number("bias", 0.005, 0, 10, "rad/s", "σ of what it is off by from the start, drawn once"),
      number("drift", 0.0002, 0, 10, "rad/s/√s", "σ of what that has changed by after a second"),
      number("white", 0.003, 0, 10, "rad/s", "σ of each reading, at 100 readings in a second")),
  /** A pan-tilt unit; it aims the devices that name it as their parent. */
  PAN_TILT("pan-tilt"),
  /** A camera for visible light; its optical axis is its x axis. */
  CAMERA(
      "camera",
      number("width", 320, 8, 2048, "", "pixels in a row"),
      number("height", 240, 8, 2048, "", "rows"),
      number("field_of_view", 1.05, 0.05, 2.8, "rad", "from the left edge to the right"),
      number("white", 3, 0, 100, "", "σ of each colour of each pixel, of 255")),
  /** A thermal camera; its optical axis is its x axis. */
  THERMAL(
      "thermal",
      number("width", 320, 8, 2048, "", "pixels in a row"),
      number("height", 240, 8, 2048, "", "rows"),
      number("field_of_view", 0.8, 0.05, 2.8, "rad", "from the left edge to the right"),
      number("white", 0.08, 0, 10, "K", "σ of each pixel")),
  /** The battery that powers a robot. */
  BATTERY(
      "battery",
      number("capacity", 28, 5.2, 0.01, 10000, "Ah", "what it holds"),
      number("charge", 1, 1, 0, 1, "", "part of that at the start"),
      number("full", 25.7, 16.8, 1, 1000, "V", "its voltage when full, without load"),
      number("empty", 23.6, 13.2, 0.1, 1000, "V", "its voltage when empty, without load"),
      number("resistance", 0.04, 0.015, 0, 10, "Ω", "inside of it"),
      number("idle", 60, 12, 0, 1e5, "W", "what the robot takes standing"),
      number(
          "motion",
          150,
          12,
          0,
          1e5,
          "W s/m",
          "what it takes besides, by speed; of a uav through the air"),
      number("turning", 90, 0, 0, 1e5, "W s/rad", "what it takes besides, by rate of turn"),
      number("hover", 0, 190, 0, 1e5, "W", "what it takes besides while the rotors lift it")),
  /** The autopilot of a UAV with its rotors. */
  FLIGHT(
      "flight",
      number("max_speed", 8, 0.1, 100, "m/s", "the fastest over ground"),
      number("max_acceleration", 3, 0.1, 100, "m/s²", "the most, in any direction"),
      number("max_climb", 2.5, 0.1, 50, "m/s", "the fastest upwards"),
      number("max_descent", 1.5, 0.1, 50, "m/s", "the fastest downwards"),
      number("max_yaw_rate", 1.5, 0.01, 20, "rad/s", "the fastest turn of its nose"),
      number("gust_response", 0.3, 0, 10, "1/s", "acceleration by a gust, by the gust's speed"));

  private final String text;
  private final List<DeviceParameter> parameters;

  DeviceKind(String text, DeviceParameter... parameters) {
    this.text = text;
    this.parameters = List.of(parameters);
  }

  /** Its name in XML, such as {@code pan-tilt}. */
  public String text() {
    return text;
  }

  /** Its parameters. */
  public List<DeviceParameter> parameters() {
    return parameters;
  }

  /** The parameter of that name, if there is one. */
  public Optional<DeviceParameter> parameter(String name) {
    return parameters.stream().filter(parameter -> parameter.name().equals(name)).findFirst();
  }

  private static DeviceParameter number(
      String name, double standard, double lowest, double highest, String unit, String meaning) {
    return number(name, standard, standard, lowest, highest, unit, meaning);
  }

  private static DeviceParameter number(
      String name,
      double ugv,
      double uav,
      double lowest,
      double highest,
      String unit,
      String meaning) {
    return new DeviceParameter(name, ugv, uav, lowest, highest, unit, meaning);
  }
}
