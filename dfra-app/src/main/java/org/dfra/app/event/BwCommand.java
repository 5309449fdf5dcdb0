package org.dfra.app.event;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import net.jini.io.MarshalOutputStream;
import org.dfra.event.Delivery;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;

/** {@code ./dfra event bw}. */
@Command(
    name = "bw",
    description =
        "Measures how many bytes a module's events take, readings unless --kind says else.",
    footer = {
      "",
      "An event counts as many bytes as it has when it is marshalled for a call; what",
      "the call itself, TCP and IP add is left out. A line each second, and one at the",
      "end: by --count, --for or Ctrl-C."
    })
final class BwCommand extends MeasurementCommand {

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
