package org.dfra.examples.devices;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.dfra.directory.ModuleListing;
import org.dfra.event.Reading;
import org.dfra.flow.effector.DriveState;
import org.dfra.flow.effector.PanTiltState;
import org.dfra.flow.sensor.AngularRate;
import org.dfra.flow.sensor.BatteryState;
import org.dfra.flow.sensor.CameraImage;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.flow.sensor.Odometry;
import org.dfra.flow.sensor.RangeScan;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.dfra.module.Module;

/** A subscription to the readings of each device. */
final class DeviceRecorders implements AutoCloseable {

  final ReadingRecorder<DriveState> drive;
  final ReadingRecorder<Odometry> odometry;
  final ReadingRecorder<GpsFix> gps;
  final ReadingRecorder<RangeScan> laser;
  final ReadingRecorder<AngularRate> gyro;
  final ReadingRecorder<PanTiltState> panTilt;
  final ReadingRecorder<CameraImage> camera;
  final ReadingRecorder<CameraImage> thermal;
  final ReadingRecorder<BatteryState> battery;

  /** The robot's pose by odometry, across restarts of its driver. */
  final ContinuousOdometry track = new ContinuousOdometry();

  /** All received scans, for the map. */
  final ScanMap map = new ScanMap();

  private final Instant begin;

  /**
   * Subscribes to all devices.
   *
   * @param datum of the field, where east and north are 0
   */
  DeviceRecorders(RobotDevices devices, GeoPosition datum, Instant begin) throws Exception {
    this.begin = begin;
    LocalFrame field = new LocalFrame(datum);
    odometry =
        log(
            devices.one(devices.odometry),
            Odometry.class,
            List.of("x_m", "y_m", "yaw_rad", "speed_mps", "yaw_rate_radps"),
            (counted, epoch) -> {
              Odometry o = track.next(counted, epoch);
              map.at(o);
              return new double[] {o.x(), o.y(), o.yaw(), o.speed(), o.yawRate()};
            });
    drive =
        log(
            devices.one(devices.drive),
            DriveState.class,
            List.of("speed_mps", "yaw_rate_radps", "silences"),
            (d, epoch) ->
                new double[] {d.velocity().speed(), d.velocity().yawRate(), d.commandTimeouts()});
    gps =
        log(
            devices.one(devices.gps),
            GpsFix.class,
            List.of("east_m", "north_m", "satellites"),
            (fix, epoch) -> local(field, fix));
    laser =
        log(
            devices.one(devices.laser),
            RangeScan.class,
            List.of("nearest_m", "measured_beams"),
            (scan, epoch) -> {
              map.add(scan);
              return nearest(scan);
            });
    gyro =
        log(
            devices.one(devices.gyro),
            AngularRate.class,
            List.of("rate_radps"),
            (rate, epoch) -> new double[] {rate.rate()});
    panTilt =
        log(
            devices.one(devices.panTilt),
            PanTiltState.class,
            List.of("pan_rad", "tilt_rad"),
            (state, epoch) -> new double[] {state.pan(), state.tilt()});
    camera =
        log(
            devices.one(devices.camera),
            CameraImage.class,
            List.of("bytes"),
            (i, epoch) -> size(i));
    thermal =
        log(
            devices.one(devices.thermal),
            CameraImage.class,
            List.of("bytes"),
            (i, epoch) -> size(i));
    battery =
        log(
            devices.one(devices.battery),
            BatteryState.class,
            List.of("voltage_v", "remaining"),
            (b, epoch) ->
                new double[] {b.voltage(), b.remaining() == null ? Double.NaN : b.remaining()});
  }

  private <R extends Reading> ReadingRecorder<R> log(
      ModuleListing<? extends Module> listing,
      Class<R> type,
      List<String> columns,
      ReadingRecorder.ColumnExtractor<R> numbers)
      throws Exception {
    return new ReadingRecorder<>(listing.path(), type, columns, numbers, begin)
        .subscribeTo(listing.module());
  }

  private static double[] local(LocalFrame field, GpsFix fix) {
    GeoPosition at = fix.position();
    if (at == null) {
      return new double[] {Double.NaN, Double.NaN, fix.satellitesTracked()};
    }
    LocalPosition local = field.toLocal(at);
    return new double[] {local.east(), local.north(), fix.satellitesTracked()};
  }

  private static double[] nearest(RangeScan scan) {
    double nearest = Double.NaN;
    int measured = 0;
    for (int i = 0; i < scan.beams(); i++) {
      if (scan.isMeasured(i)) {
        measured++;
        nearest = Double.isNaN(nearest) ? scan.range(i) : Math.min(nearest, scan.range(i));
      }
    }
    return new double[] {nearest, measured};
  }

  private static double[] size(CameraImage image) {
    return new double[] {image.size()};
  }

  /** All recorders, in publication order. */
  List<ReadingRecorder<?>> all() {
    return List.of(drive, odometry, gps, laser, gyro, panTilt, camera, thermal, battery);
  }

  /** Writes a CSV file for each. */
  void write(Path folder) throws IOException {
    for (ReadingRecorder<?> each : all()) {
      each.write(folder.resolve(each.path().replace('/', '-') + ".csv"));
    }
  }

  @Override
  public void close() {
    all().forEach(ReadingRecorder::close);
  }
}
