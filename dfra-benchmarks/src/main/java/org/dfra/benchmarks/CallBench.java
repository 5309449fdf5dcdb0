package org.dfra.benchmarks;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.lang.reflect.Method;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.UUID;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.attack.RawCall;
import org.dfra.benchmarks.event.BenchSensor;
import org.dfra.flow.effector.Command;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.dfra.river.remote.sensor.RemoteGPSSensor;
import org.dfra.river.server.sensor.GPSServer;

/**
 * Measures the duration of a small remote call over the loopback, and the share of the stream
 * check: the server checks the request and the client the response before any object is built. The
 * check is also timed alone, on the bytes of one recorded call, in rounds that alternate with
 * rounds of calls.
 */
final class CallBench implements Bench {

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final Duration PATIENCE = Duration.ofSeconds(20);
  private static final Duration START = Duration.ofSeconds(1); // below the call timeout
  private static final long LEASE = 30_000;

  /** Bytes of a request before its object stream: protocol version and integrity. */
  private static final int OPENING = 2;

  private static final int BUFFER = 1024;
  private static final int ROUNDS = 30;
  private static final int CALLS = 500;
  private static final int SCANS = 10_000;
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double PERCENT = 100;

  /** Object streams of a call as they are sent. */
  private record Recorded(byte[] request, byte[] answer) {}

  @Override
  public void run(Report report) throws Exception {
    byte[] command =
        objectStream(
            CallBytes.of(
                RemoteDriveEffector.class.getMethod("execute", CommandKey.class, Command.class),
                new CommandKey(UUID.randomUUID()),
                new Velocity(0.3, 0)));
    try (BenchRegistrar reggie = new BenchRegistrar(LEASE);
        GPSServer server = BenchSensor.serve(List.of(reggie.locator()))) {
      RemoteGPSSensor gps = (RemoteGPSSensor) server.getProxy(); // by TCP, also from here
      if (!gps.awaitReadiness(START).serves()) {
        throw new IOException(server.identification().path() + " is not ready after " + START);
      }
      Recorded question = record(gps, RemoteGPSSensor.class.getMethod("fix"));
      report.say(
          "Calling fix() over the loopback: a request of "
              + question.request().length
              + " bytes, an answer of "
              + question.answer().length
              + "; a command of the wheels has "
              + command.length
              + " …");
      measure(report, gps, question, command);
    }
  }

  /** One call as the client sends it, and the server's response. */
  private static Recorded record(RemoteGPSSensor gps, Method method)
      throws IOException, InterruptedException {
    byte[] bytes = CallBytes.of(method);
    try (RawCall call = RawCall.to(gps)) {
      RawCall.Answer answer = call.send(bytes).finish(PATIENCE);
      if (answer.status() != RawCall.Status.RETURNED) {
        throw new IOException(method.getName() + "() gave " + answer.status(), answer.failure());
      }
      return new Recorded(objectStream(bytes), answer.bytes());
    }
  }

  private static byte[] objectStream(byte[] request) {
    return Arrays.copyOfRange(request, OPENING, request.length);
  }

  private static void measure(Report report, RemoteGPSSensor gps, Recorded question, byte[] command)
      throws IOException {
    double[] micros = new double[ROUNDS * CALLS];
    double[] ofRequest = new double[ROUNDS];
    double[] ofAnswer = new double[ROUNDS];
    double[] ofCommand = new double[ROUNDS];
    for (int i = 0; i < 2 * ROUNDS; i++) { // the first half warms up
      int round = i % ROUNDS;
      call(gps, micros, round * CALLS);
      ofRequest[round] = scan(question.request());
      ofAnswer[round] = scan(question.answer());
      ofCommand[round] = scan(command);
    }
    double median = Report.quantile(micros, 0.5);
    double request = Report.quantile(ofRequest, 0.5);
    double answer = Report.quantile(ofAnswer, 0.5);
    report.figure("call of fix(), from request to result, median", median, "µs");
    report.figure("call of fix(), p99", Report.quantile(micros, 0.99), "µs");
    report.figure("check of its request, processor time, median", request, "ns");
    report.figure("check of its answer, processor time, median", answer, "ns");
    report.figure(
        "both checks, of the call's median",
        PERCENT * (request + answer) / (median * NANOS_PER_MICRO),
        "%");
    report.figure(
        "check of a command of the wheels, processor time, median",
        Report.quantile(ofCommand, 0.5),
        "ns");
  }

  /** Makes this many calls and times each, microseconds. */
  private static void call(RemoteGPSSensor gps, double[] micros, int from) throws IOException {
    for (int i = 0; i < CALLS; i++) {
      long began = System.nanoTime();
      GpsFix fix = gps.fix();
      micros[from + i] = (System.nanoTime() - began) / NANOS_PER_MICRO;
      if (fix.mode() != GpsFix.Mode.FIX_3D) {
        throw new RemoteException("the receiver of the benchmark answered " + fix);
      }
    }
  }

  /** CPU time of reading an object stream through its check, nanoseconds. */
  private static double scan(byte[] stream) throws IOException {
    byte[] buffer = new byte[BUFFER];
    long read = 0;
    long began = THREADS.getCurrentThreadCpuTime();
    for (int i = 0; i < SCANS; i++) {
      InputStream in = SerialFilters.checked(new ByteArrayInputStream(stream));
      for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
        read += count;
      }
    }
    long took = THREADS.getCurrentThreadCpuTime() - began;
    if (read != (long) SCANS * stream.length) {
      throw new IOException("the check let " + read + " bytes pass, not " + SCANS + " streams");
    }
    return took / (double) SCANS;
  }
}
