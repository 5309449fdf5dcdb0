package org.dfra.cli.event;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import java.util.Locale;
import net.jini.io.MarshalOutputStream;
import org.dfra.cli.event.EventWindow.SummaryStatistics;
import org.dfra.event.Delivery;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;

/** {@code ./dfra event}: the events that modules publish. */
@Command(
    name = "event",
    description = "Shows a module's events, and measures their rate, size and noise.",
    synopsisSubcommandLabel = "COMMAND",
    commandListHeading = "%nCommands:%n",
    subcommands = {
      EchoCommand.class,
      EventCommand.HzCommand.class,
      EventCommand.BwCommand.class,
      NoiseCommand.class
    })
public final class EventCommand {

  /** {@code ./dfra event hz}. */
  @Command(
      name = "hz",
      description = "Measures the rate of a module's events (readings, or what --kind names).",
      footer = {
        "",
        "Intervals are those between arrivals here. Prints a line each second, and one at the",
        "end: by --count, --for or Ctrl-C."
      })
  static final class HzCommand extends MeasurementCommand {

    /** Rates in hertz, intervals in seconds; null if there were too few events. */
    record RateReport(
        long events,
        int window,
        long lost,
        @Nullable Double rate,
        @Nullable Double minInterval,
        @Nullable Double maxInterval,
        @Nullable Double deviation) {}

    @Override
    long size(Delivery delivery) {
      return 0; // not measured
    }

    @Override
    Object value(EventWindow events, long lost) {
      SummaryStatistics intervals = events.intervals();
      return new RateReport(
          events.totalCount(),
          events.size(),
          lost,
          NumberFormats.orNull(events.rate()),
          NumberFormats.orNull(intervals.min()),
          NumberFormats.orNull(intervals.max()),
          NumberFormats.orNull(intervals.standardDeviation()));
    }

    @Override
    String inWords(EventWindow events) {
      SummaryStatistics intervals = events.intervals();
      return String.format(
          Locale.ROOT,
          "%s Hz; interval min %.4f s, max %.4f s, std %.4f s",
          NumberFormats.fourDigits(events.rate()),
          intervals.min(),
          intervals.max(),
          intervals.standardDeviation());
    }
  }

  /** {@code ./dfra event bw}. */
  @Command(
      name = "bw",
      description = "Measures the bytes of a module's events (readings, or what --kind names).",
      footer = {
        "",
        "The size of an event is its size when it is marshalled for a call, without the",
        "overhead of the call itself, TCP and IP. Prints a line each second, and one at the",
        "end: by --count, --for or Ctrl-C."
      })
  static final class BwCommand extends MeasurementCommand {

    /** Sizes in bytes, rates in bytes per second; null if there were too few events. */
    record BandwidthReport(
        long events,
        int window,
        long lost,
        @Nullable Double bytesPerSecond,
        @Nullable Double meanSize,
        @Nullable Double minSize,
        @Nullable Double maxSize) {}

    @Override
    long size(Delivery delivery) {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      try (MarshalOutputStream out = new MarshalOutputStream(bytes, List.of())) {
        out.writeObject(delivery);
      } catch (IOException e) {
        throw new UncheckedIOException(e); // into memory; it was received as such an object
      }
      return bytes.size();
    }

    @Override
    Object value(EventWindow events, long lost) {
      SummaryStatistics sizes = events.sizes();
      return new BandwidthReport(
          events.totalCount(),
          events.size(),
          lost,
          NumberFormats.orNull(events.bytesPerSecond()),
          NumberFormats.orNull(sizes.mean()),
          NumberFormats.orNull(sizes.min()),
          NumberFormats.orNull(sizes.max()));
    }

    @Override
    String inWords(EventWindow events) {
      SummaryStatistics sizes = events.sizes();
      return NumberFormats.bytes(events.bytesPerSecond())
          + "/s; size mean "
          + NumberFormats.bytes(sizes.mean())
          + ", min "
          + NumberFormats.bytes(sizes.min())
          + ", max "
          + NumberFormats.bytes(sizes.max());
    }
  }

  /** Formats of measured numbers. */
  static final class NumberFormats {

    private static final double KILO = 1000;
    private static final MathContext FOUR = new MathContext(4, RoundingMode.HALF_EVEN);

    private NumberFormats() {}

    /** The number; null for NaN. */
    static @Nullable Double orNull(double number) {
      return Double.isFinite(number) ? number : null;
    }

    /** {@code 0.9998}, {@code 12.35}, {@code 12350}. */
    static String fourDigits(double number) {
      return Double.isFinite(number)
          ? new BigDecimal(number).round(FOUR).toPlainString()
          : "an unknown number of";
    }

    /** {@code 812 B}, {@code 1.234 kB}, {@code 12.35 MB}: a kilobyte has 1000 bytes. */
    static String bytes(double bytes) {
      if (bytes < KILO) {
        return fourDigits(bytes) + " B";
      }
      return bytes < KILO * KILO
          ? fourDigits(bytes / KILO) + " kB"
          : fourDigits(bytes / KILO / KILO) + " MB";
    }
  }
}
