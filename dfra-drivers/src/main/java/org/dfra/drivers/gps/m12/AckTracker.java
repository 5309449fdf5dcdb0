package org.dfra.drivers.gps.m12;

import java.io.IOException;
import java.time.Duration;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.dfra.drivers.link.SerialLink;
import org.dfra.drivers.link.Ticker;
import org.jspecify.annotations.Nullable;

/**
 * Sends settings that the receiver acknowledges with a message of the same ID, and resends them
 * until they are acknowledged. Confined to the reader thread.
 */
final class AckTracker {

  private static final Duration PATIENCE = Duration.ofSeconds(3);
  private static final int TRIES = 3;

  private record Open(byte[] command, int tries, long sentNanos) {}

  private final Ticker ticker;
  private final Map<String, Open> open = new LinkedHashMap<>();

  AckTracker(Ticker ticker) {
    this.ticker = ticker;
  }

  /** Drops all pending settings. */
  void forget() {
    open.clear();
  }

  void send(SerialLink link, String id, byte[] command) throws IOException {
    open.put(id, new Open(command, 1, ticker.nanos()));
    link.write(command);
  }

  /** The receiver has acknowledged a setting. */
  void acknowledge(String id) {
    open.remove(id);
  }

  /**
   * Resends what is due; returns the ID of a setting that is given up without an acknowledgement,
   * or null.
   */
  @Nullable String resendDue(SerialLink link) throws IOException {
    for (Iterator<Map.Entry<String, Open>> all = open.entrySet().iterator(); all.hasNext(); ) {
      Map.Entry<String, Open> entry = all.next();
      Open last = entry.getValue();
      if (ticker.nanos() - last.sentNanos() <= PATIENCE.toNanos()) {
        continue;
      }
      if (last.tries() == TRIES) {
        all.remove();
        return entry.getKey();
      }
      entry.setValue(new Open(last.command(), last.tries() + 1, ticker.nanos()));
      link.write(last.command());
    }
    return null;
  }
}
