package org.dfra.sim.world.description;

import java.util.List;
import java.util.Optional;
import org.dfra.sim.world.description.DeviceDescription.DeviceParameter;

/** The kinds of device that a robot can carry, with the parameters of each. */
public enum DeviceKind {
  /** A satellite receiver; its mount is where its antenna is. */
  GPS(
      "gps",
      number(
          "white_noise_sigma",
          0.6,
          0,
          100,
          "m",
          "σ of the white noise of each position, east and north each"),
      number("bias_sigma", 1.5, 0, 100, "m", "σ of the slowly changing error, east and north each"),
      number(
          "bias_correlation_time",
          200,
          0.1,
          1e6,
          "s",
          "correlation time of the slowly changing error"),
      number("vertical_factor", 1.5, 0, 100, "", "ratio of the vertical to the horizontal errors"),
      number("velocity_sigma", 0.05, 0, 100, "m/s", "σ of the velocity, east and north each"),
      number(
          "outages_per_hour", 0, 0, 3600, "", "outages per hour, in which it loses all satellites"),
      number("mean_outage_duration", 20, 0.1, 3600, "s", "average duration of an outage")),
  /** A range finder with a beam that rotates in its x-y plane. */
  LASER(
      "laser",
      number("white_noise_sigma", 0.01, 0, 10, "m", "σ of each range"),
      number("dropout_probability", 0.002, 0, 1, "", "fraction of the beams that return nothing"),
      number(
          "range_at_10_percent",
          10,
          0.1,
          1000,
          "m",
          "reach for targets that reflect a tenth of its light"),
      number(
          "ghost_rate",
          0.5,
          0,
          100,
          "/s",
          "ghosts per second: short false ranges from uneven terrain"),
      number("ghost_duration", 0.15, 0.01, 10, "s", "average duration of a ghost"),
      number("ghost_width", 0.07, 0.001, 3, "rad", "average width of a ghost"),
      number("ghost_min_range", 0.6, 0, 1000, "m", "minimum range of a ghost"),
      number("ghost_max_range", 5, 0, 1000, "m", "maximum range of a ghost")),
  /** The wheels of a UGV with their motors and encoders. */
  DRIVE(
      "drive",
      number(
          "effective_track",
          0.75,
          0.05,
          10,
          "m",
          "effective distance between the left and the right wheels"),
      number("max_wheel_speed", 1.2, 0.01, 20, "m/s", "maximum speed of a side"),
      number("max_acceleration", 8, 0.01, 100, "m/s²", "maximum acceleration of a side"),
      number("brake_deceleration", 8, 0.01, 100, "m/s²", "deceleration of a side by the brakes"),
      number(
          "slip",
          0.02,
          -0.5,
          0.9,
          "",
          "fraction of the wheels' distance that the body does not make"),
      number("slip_sigma", 0.02, 0, 0.5, "", "σ of the changes of the slip"),
      number(
          "yaw_slip",
          0.05,
          -0.5,
          0.9,
          "",
          "fraction of the wheels' rotation that the body does not make"),
      number("yaw_slip_sigma", 0.05, 0, 0.5, "", "σ of the changes of the yaw slip"),
      number("slip_correlation_time", 2, 0.01, 1e6, "s", "correlation time of both slips"),
      number(
          "encoder_scale_sigma",
          0.005,
          0,
          0.2,
          "",
          "σ of the scale error of each side, drawn once"),
      number(
          "left_encoder_scale_error",
          0,
          -0.5,
          0.5,
          "",
          "additional scale error of the left side, + measures too much"),
      number(
          "right_encoder_scale_error",
          0,
          -0.5,
          0.5,
          "",
          "additional scale error of the right side, + measures too much")),
  /** A rate gyro; it measures about its z axis. */
  GYRO(
      "gyro",
      number("bias_sigma", 0.005, 0, 10, "rad/s", "σ of the initial bias, drawn once"),
      number(
          "bias_random_walk", 0.0002, 0, 10, "rad/s/√s", "σ of the change of the bias in a second"),
      number(
          "white_noise_sigma",
          0.003,
          0,
          10,
          "rad/s",
          "σ of each reading, at 100 readings per second")),
  /** A pan-tilt unit; it aims the devices that name it as their parent. */
  PAN_TILT("pan-tilt"),
  /** A camera for visible light; its optical axis is its x axis. */
  CAMERA(
      "camera",
      number("width", 320, 8, 2048, "", "pixels in a row"),
      number("height", 240, 8, 2048, "", "rows"),
      number("field_of_view", 1.05, 0.05, 2.8, "rad", "horizontal field of view"),
      number("white_noise_sigma", 3, 0, 100, "", "σ of each colour of each pixel, of 255")),
  /** A thermal camera; its optical axis is its x axis. */
  THERMAL(
      "thermal",
      number("width", 320, 8, 2048, "", "pixels in a row"),
      number("height", 240, 8, 2048, "", "rows"),
      number("field_of_view", 0.8, 0.05, 2.8, "rad", "horizontal field of view"),
      number("white_noise_sigma", 0.08, 0, 10, "K", "σ of each pixel")),
  /** The battery that powers a robot. */
  BATTERY(
      "battery",
      number("capacity", 28, 5.2, 0.01, 10000, "Ah", "its charge when full"),
      number("initial_charge", 1, 1, 0, 1, "", "fraction of the capacity at the start"),
      number("full_voltage", 25.7, 16.8, 1, 1000, "V", "its voltage when full, without load"),
      number("empty_voltage", 23.6, 13.2, 0.1, 1000, "V", "its voltage when empty, without load"),
      number("internal_resistance", 0.04, 0.015, 0, 10, "Ω", "its internal resistance"),
      number("idle_power", 60, 12, 0, 1e5, "W", "power of the robot at standstill"),
      number(
          "power_per_speed",
          150,
          12,
          0,
          1e5,
          "W s/m",
          "additional power per speed; of a uav, per speed through the air"),
      number("power_per_yaw_rate", 90, 0, 0, 1e5, "W s/rad", "additional power per yaw rate"),
      number("hover_power", 0, 190, 0, 1e5, "W", "additional power while the rotors lift it")),
  /** The autopilot of a UAV with its rotors. */
  FLIGHT(
      "flight",
      number("max_speed", 8, 0.1, 100, "m/s", "maximum speed over ground"),
      number("max_acceleration", 3, 0.1, 100, "m/s²", "maximum acceleration, in any direction"),
      number("max_climb", 2.5, 0.1, 50, "m/s", "maximum speed upwards"),
      number("max_descent", 1.5, 0.1, 50, "m/s", "maximum speed downwards"),
      number("max_yaw_rate", 1.5, 0.01, 20, "rad/s", "maximum yaw rate"),
      number("gust_response", 0.3, 0, 10, "1/s", "acceleration by a gust, per speed of the gust"));

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
