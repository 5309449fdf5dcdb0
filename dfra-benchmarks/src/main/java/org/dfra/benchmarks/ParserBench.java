package org.dfra.benchmarks;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.benchmarks.micro.DeviceRecording;
import org.dfra.drivers.gps.gpsd.GpsdParser;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.nmea.NmeaParser;
import org.dfra.drivers.gps.ubx.UbxCommands;
import org.dfra.drivers.gps.ubx.UbxParser;
import org.dfra.drivers.laser.lms.LmsCommands;
import org.dfra.drivers.laser.lms.LmsParser;
import org.dfra.drivers.laser.lms.LmsScan;
import org.dfra.drivers.laser.lms.MeasuringMode;
import org.dfra.sim.device.gps.GpsdDevice;
import org.dfra.sim.device.gps.UbxDevice;
import org.dfra.sim.device.laser.LmsDevice;
import org.dfra.sim.device.laser.LmsEmulatorSettings;

/**
 * Measures the throughput of the device parsers on five minutes of output of the emulated devices,
 * in blocks of a driver's buffer size. 20 ns per byte are 50 MB/s.
 */
final class ParserBench implements Bench {

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final int ROUNDS = 30;
  private static final int ROUND_BYTES = 4_000_000;
  private static final double MOST_NANOS_PER_BYTE = 20;
  private static final MeasuringMode MODE = MeasuringMode.of(0).orElseThrow();

  /** Consumes bytes. */
  @FunctionalInterface
  private interface Feed {
    void bytes(byte[] bytes, int offset, int length);
  }

  @Override
  public void run(Report report) {
    AtomicLong messages = new AtomicLong();
    AtomicLong beams = new AtomicLong();
    measure(
        report,
        "Motorola binary",
        DeviceRecording.m12(),
        new M12Parser(message -> messages.incrementAndGet())::feed);
    measure(
        report,
        "NMEA 0183",
        DeviceRecording.nmea(),
        new NmeaParser(message -> messages.incrementAndGet())::feed);
    measure(
        report,
        "u-blox UBX",
        DeviceRecording.of(
            new UbxDevice(DeviceRecording.PATH, DeviceRecording.BAUD, Duration.ZERO),
            List.of(UbxCommands.positions(), UbxCommands.satellites(5))),
        new UbxParser(message -> messages.incrementAndGet())::feed);
    measure(
        report,
        "gpsd JSON",
        DeviceRecording.of(
            new GpsdDevice(DeviceRecording.PATH, DeviceRecording.BAUD, Duration.ZERO),
            List.of("?WATCH={\"enable\":true,\"json\":true};".getBytes(StandardCharsets.US_ASCII))),
        new GpsdParser(message -> messages.incrementAndGet())::feed);
    measure(
        report,
        "SICK LMS 200",
        DeviceRecording.of(
            new LmsDevice(
                ParserBench::scene, LmsEmulatorSettings.factoryDefault().withBaud(500_000)),
            List.of(LmsCommands.stream())),
        new LmsParser(
                message -> {
                  messages.incrementAndGet();
                  if (message instanceof LmsScan scan) {
                    beams.addAndGet(scan.ranges(MODE).length);
                  }
                })
            ::feed);
    report.say(messages.get() + " messages were decoded, " + beams.get() + " beams in them.");
  }

  /** A room around the laser; its far wall is out of range. */
  private static void scene(
      Instant time, double first, double step, double longest, double[] distances) {
    for (int i = 0; i < distances.length; i++) {
      distances[i] = 2 + 10 * Math.abs(Math.sin(3 * (first + i * step)));
    }
  }

  private static void measure(Report report, String what, byte[] recording, Feed feed) {
    double[] nanosPerByte = new double[ROUNDS];
    for (int round = 0; round < 2 * ROUNDS; round++) { // the first half warms up
      long fed = 0;
      long began = THREADS.getCurrentThreadCpuTime();
      while (fed < ROUND_BYTES) {
        for (int at = 0; at < recording.length; at += DeviceRecording.BUFFER_BYTES) {
          feed.bytes(recording, at, Math.min(DeviceRecording.BUFFER_BYTES, recording.length - at));
        }
        fed += recording.length;
      }
      nanosPerByte[round % ROUNDS] = (THREADS.getCurrentThreadCpuTime() - began) / (double) fed;
    }
    double median = Report.quantile(nanosPerByte, 0.5);
    report.figure(what + ", processor time for a byte, median", median, MOST_NANOS_PER_BYTE, "ns");
    report.figure(what + ", throughput, median", 1e3 / median, "MB/s");
  }
}
