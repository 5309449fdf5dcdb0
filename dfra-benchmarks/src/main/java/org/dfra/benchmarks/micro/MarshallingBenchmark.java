package org.dfra.benchmarks.micro;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Method;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.TimeUnit;
import net.jini.io.MarshalInputStream;
import net.jini.io.MarshalOutputStream;
import org.dfra.benchmarks.attack.CallBytes;
import org.dfra.benchmarks.event.CallSize;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.flow.perceptual.PoseEstimate;
import org.dfra.flow.perceptual.PositionEstimator;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.remote.RemoteModuleListener;
import org.dfra.time.ClockOffset;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * Writing and reading of what robots send most: an event, as the argument of the call that notifies
 * a listener, and a percept, as the result of a call. DFRA writes River's streams, which annotate
 * classes; it reads them with the checks and filters of a call, but without transport. Beside that,
 * the same objects in the JDK's object streams without filter. Microseconds.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class MarshallingBenchmark {

  private static final Instant TIME = Instant.parse("2026-11-21T12:00:00.2Z");
  private static final ClassLoader LOADER = MarshallingBenchmark.class.getClassLoader();

  /** Bytes of a request before its object stream: protocol version and integrity. */
  private static final int OPENING = 2;

  /** A receiver's reading on its way to a listener. */
  static final Delivery EVENT =
      new Delivery(
          "atrv1/gps_front",
          3,
          48_211,
          0,
          TIME.plusMillis(12),
          new NewReading(
              new GpsFix(
                  GpsFix.Mode.FIX_3D,
                  new GeoPosition(27.950603, -82.4572, 12.4),
                  TIME,
                  0.61,
                  87.5,
                  1.8,
                  11,
                  9)));

  /** A robot's pose, as its position estimator returns it. */
  static final PoseEstimate PERCEPT =
      new PoseEstimate(
          TIME,
          "atrv1/map",
          new GeoPosition(27.9506, -82.4572, 12),
          14.27,
          -3.82,
          1.31,
          0.58,
          0.04,
          0.16,
          0.02,
          Duration.ofMillis(412),
          new ClockOffset(Duration.ofMillis(3), Duration.ofMillis(12)));

  private final Method notify;
  private final Method estimate;
  private final ArgumentReader listener;
  private final byte[] event;
  private final byte[] eventPlain;
  private final byte[] percept;
  private final byte[] perceptPlain;

  /** For JMH. */
  public MarshallingBenchmark() {
    try {
      notify = CallSize.notifyMethod();
      estimate = PositionEstimator.class.getMethod("estimate");
      RemoteModuleListener callee = delivery -> {};
      listener = new ArgumentReader(notify, callee);
      event = CallBytes.of(notify, EVENT, 1L, 1L);
      percept = answer(PERCEPT);
      eventPlain = writePlain(EVENT);
      perceptPlain = writePlain(PERCEPT);
    } catch (NoSuchMethodException | ExportException e) {
      throw new IllegalStateException(e);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static byte[] answer(Object result) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      out.writeObject(result);
    }
    return bytes.toByteArray();
  }

  private static byte[] writePlain(Object object) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    return bytes.toByteArray();
  }

  private static Object readPlain(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      return in.readObject();
    }
  }

  /**
   * Writes the call that notifies a listener of the event.
   *
   * @throws IOException never
   */
  @Benchmark
  public byte[] writeEvent() throws IOException {
    return CallBytes.of(notify, EVENT, 1L, 1L);
  }

  /**
   * Writes the event as plain Java does.
   *
   * @throws IOException never
   */
  @Benchmark
  public byte[] writeEventPlain() throws IOException {
    return writePlain(EVENT);
  }

  /**
   * Checks and reads the arguments of that call.
   *
   * @throws IOException if they are refused
   * @throws ReflectiveOperationException if one of their classes is unknown
   */
  @Benchmark
  public Object readEvent() throws IOException, ReflectiveOperationException {
    return listener.read(event, OPENING)[0];
  }

  /**
   * The same once more, to be compared with {@link #readEventUnchecked}.
   *
   * @throws IOException if they are refused
   * @throws ReflectiveOperationException if one of their classes is unknown
   */
  @Benchmark
  public Object readEventChecked() throws IOException, ReflectiveOperationException {
    return readEvent();
  }

  /**
   * Reads the arguments of that call from River's stream without any check or filter.
   *
   * @throws IOException never
   * @throws ClassNotFoundException never
   */
  @Benchmark
  public Object readEventUnchecked() throws IOException, ClassNotFoundException {
    try (MarshalInputStream in =
        new MarshalInputStream(
            new ByteArrayInputStream(event, OPENING, event.length - OPENING),
            LOADER,
            false,
            LOADER,
            List.of())) {
      in.useCodebaseAnnotations(); // as River's dispatchers do
      long method = in.readLong();
      Object read = in.readObject();
      long numbers = in.readLong() + in.readLong();
      if (method == numbers) {
        throw new IOException("the call has other arguments");
      }
      return read;
    }
  }

  /**
   * Reads the event as plain Java does.
   *
   * @throws IOException never
   * @throws ClassNotFoundException never
   */
  @Benchmark
  public Object readEventPlain() throws IOException, ClassNotFoundException {
    return readPlain(eventPlain);
  }

  /**
   * Writes the answer that contains the percept.
   *
   * @throws IOException never
   */
  @Benchmark
  public byte[] writePercept() throws IOException {
    return answer(PERCEPT);
  }

  /**
   * Writes the percept as plain Java does.
   *
   * @throws IOException never
   */
  @Benchmark
  public byte[] writePerceptPlain() throws IOException {
    return writePlain(PERCEPT);
  }

  /**
   * Checks and reads that answer.
   *
   * @throws IOException if it is refused
   * @throws ClassNotFoundException if one of its classes is unknown
   */
  @Benchmark
  public Object readPercept() throws IOException, ClassNotFoundException {
    try (ObjectInputStream in =
        SerialFilters.openResult(
            new RecordedRequest(percept, 0),
            estimate,
            answer -> {
              MarshalInputStream opened =
                  new MarshalInputStream(
                      answer.getResponseInputStream(), LOADER, false, LOADER, List.of());
              opened.useCodebaseAnnotations(); // as River's invocation handlers do
              return opened;
            })) {
      return in.readObject();
    }
  }

  /**
   * Reads the percept as plain Java does.
   *
   * @throws IOException never
   * @throws ClassNotFoundException never
   */
  @Benchmark
  public Object readPerceptPlain() throws IOException, ClassNotFoundException {
    return readPlain(perceptPlain);
  }
}
