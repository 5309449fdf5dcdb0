package org.dfra.drivers.laser.lms;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/**
 * The baud rates at which the driver searches for the laser: the configured one, the last known
 * one, then the others, beginning with the power-on rate. Without a configured rate, the link's
 * rate is not changed.
 *
 * <p>Confined to the reader thread.
 */
final class LmsBaudSearch {

  private final Optional<LmsBaud> target;
  private final List<LmsBaud> all = new ArrayList<>();
  private int index;
  private boolean isFound;
  private Optional<LmsBaud> host = Optional.empty(); // what this end is set to
  private Optional<LmsBaud> laser = Optional.empty(); // what the laser reports

  LmsBaudSearch(Optional<LmsBaud> wanted) {
    this.target = wanted;
    wanted.ifPresent(all::add);
    if (wanted.isPresent()) {
      for (LmsBaud each : List.of(LmsBaud.B9600, LmsBaud.B38400, LmsBaud.B19200, LmsBaud.B500000)) {
        if (!all.contains(each)) {
          all.add(each);
        }
      }
    }
  }

  /** Restarts the search with the first rate. */
  void restart() {
    index = -1;
    isFound = false;
    host = Optional.empty();
    laser = Optional.empty();
  }

  /** Sets this end to the next rate; returns why a rate was skipped, a sentence, or null. */
  @Nullable String next(SerialLink link) {
    String warning = null;
    for (int i = 0; i < all.size(); i++) {
      index = (index + 1) % all.size();
      try {
        set(link, all.get(index));
        return warning;
      } catch (IOException e) {
        warning =
            "the laser is not searched at " + all.get(index).rate() + " baud: " + e.getMessage();
      }
    }
    return warning;
  }

  private void set(SerialLink link, LmsBaud baud) throws IOException {
    link.setBaud(baud.rate());
    host = Optional.of(baud);
    laser = Optional.empty();
  }

  /** Checks whether this end supports the configured rate; returns why not, a clause, or null. */
  @Nullable String tryWanted(SerialLink link) throws IOException {
    if (target.isEmpty() || host.isEmpty()) {
      return null;
    }
    try {
      link.setBaud(target.get().rate());
      return null;
    } catch (IOException e) {
      return "the laser stays at " + host.get().rate() + " baud: " + e.getMessage();
    } finally {
      link.setBaud(host.get().rate());
    }
  }

  /** Sets this end to the configured rate, which the laser already uses. */
  void followWanted(SerialLink link) throws IOException {
    if (target.isPresent()) {
      set(link, target.get());
    }
  }

  /** Sets this end to the power-on rate, if its rate may be set. */
  void setSlowest(SerialLink link) throws IOException {
    if (target.isPresent()) {
      set(link, LmsBaud.B9600);
    }
  }

  boolean isAtSlowest() {
    return target.isEmpty() || host.equals(Optional.of(LmsBaud.B9600));
  }

  /** The laser has answered. */
  void markFound() {
    isFound = true;
  }

  boolean isFound() {
    return isFound;
  }

  /** The laser has reported its rate. */
  void laserReported(LmsBaud baud) {
    laser = Optional.of(baud);
  }

  /** The link's rate, as far as known. */
  Optional<LmsBaud> now() {
    return laser.isPresent() ? laser : host;
  }

  /** {@code at 38400, 9600 … baud}, with a space before it, or an empty text. */
  String inWords() {
    return all.isEmpty()
        ? ""
        : all.stream()
            .map(each -> Integer.toString(each.rate()))
            .collect(Collectors.joining(", ", " (tried are ", " baud)"));
  }
}
