package org.dfra.benchmarks.micro;

import java.util.List;
import java.util.Optional;
import java.util.function.IntSupplier;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * One benchmark method, and what is reported of it.
 *
 * @param subject a group of operations, such as {@code calls}
 * @param operation what is measured
 * @param variant how, if not by DFRA's own code, such as {@code plain Java RMI}; else empty
 * @param type the class
 * @param method the method
 * @param bytes how many bytes an operation processes, if its throughput is reported; 0 if its time
 */
public record MicroBenchmark(
    String subject,
    String operation,
    String variant,
    Class<?> type,
    String method,
    IntSupplier bytes) {

  private static final String RMI = "plain Java RMI";
  private static final String STREAMS = "plain Java streams";
  private static final String DECODING = "decoding alone";

  /** Determined when first needed: to record them takes a while. */
  private static final class RecordedBytes {
    static final int MOTOROLA = DeviceRecording.m12().length;
    static final int NMEA = DeviceRecording.nmea().length;
  }

  /** All of them, each beside the one that it is compared with. */
  public static final List<MicroBenchmark> ALL =
      List.of(
          call("call that returns a number", "", "range"),
          call("call that returns a number", RMI, "rangePlain"),
          call("call that returns 361 numbers", "", "scan"),
          call("call that returns 361 numbers", RMI, "scanPlain"),
          marshalling("write an event", "", "writeEvent"),
          marshalling("write an event", STREAMS, "writeEventPlain"),
          marshalling("read an event", "", "readEvent"),
          marshalling("read an event", STREAMS, "readEventPlain"),
          marshalling("read an event with its checks", "", "readEventChecked"),
          marshalling("read an event with its checks", "no checks", "readEventUnchecked"),
          marshalling("write a percept", "", "writePercept"),
          marshalling("write a percept", STREAMS, "writePerceptPlain"),
          marshalling("read a percept", "", "readPercept"),
          marshalling("read a percept", STREAMS, "readPerceptPlain"),
          fuzzy("", "step"),
          fuzzy("inference alone", "inference"),
          parser("parse Motorola binary", "motorola", () -> RecordedBytes.MOTOROLA),
          parser("parse NMEA 0183", "nmea", () -> RecordedBytes.NMEA),
          images("search an image in light", "", "light"),
          images("search an image in light", DECODING, "lightDecoded"),
          images("search an image in heat", "", "heat"),
          images("search an image in heat", DECODING, "heatDecoded"));

  private static MicroBenchmark call(String operation, String variant, String method) {
    return timed("calls", operation, variant, CallBenchmark.class, method);
  }

  private static MicroBenchmark marshalling(String operation, String variant, String method) {
    return timed("marshalling", operation, variant, MarshallingBenchmark.class, method);
  }

  private static MicroBenchmark fuzzy(String variant, String method) {
    return timed(
        "fuzzy control",
        "step of the waypoint controller",
        variant,
        FuzzyStepBenchmark.class,
        method);
  }

  private static MicroBenchmark images(String operation, String variant, String method) {
    return timed("image search", operation, variant, TemplateMatchBenchmark.class, method);
  }

  private static MicroBenchmark timed(
      String subject, String operation, String variant, Class<?> type, String method) {
    return new MicroBenchmark(subject, operation, variant, type, method, () -> 0);
  }

  private static MicroBenchmark parser(String operation, String method, IntSupplier bytes) {
    return new MicroBenchmark("parsers", operation, "", ParserBenchmark.class, method, bytes);
  }

  /** Those whose title or ID contains a match; all if there is no pattern. */
  public static List<MicroBenchmark> matching(@Nullable Pattern only) {
    return ALL.stream()
        .filter(
            each ->
                only == null || only.matcher(each.title()).find() || only.matcher(each.id()).find())
        .toList();
  }

  /** The operation, and its variant if there is one. */
  public String title() {
    return variant.isEmpty() ? operation : operation + ", " + variant;
  }

  /** The names of class and method: {@code CallBenchmark.range}. */
  public String id() {
    return type.getSimpleName() + "." + method;
  }

  /** The name by which JMH knows it. */
  public String name() {
    return type.getName() + "." + method;
  }

  /** What it is compared with: another variant of the same operation. Variants have none. */
  Optional<MicroBenchmark> peer() {
    return ALL.stream()
        .filter(each -> variant.isEmpty() && each.operation.equals(operation))
        .filter(each -> !each.variant.isEmpty())
        .findFirst();
  }
}
