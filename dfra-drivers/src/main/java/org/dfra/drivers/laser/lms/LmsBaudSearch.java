package org.dfra.drivers.laser.lms;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/**
 * The speeds at which the laser is searched: the wanted one, where it was left, then the others,
 * beginning with where it wakes. Where none is wanted, the line's is left alone.
 *
 * <p>Confined to the reader thread.
 */
final class LmsBaudSearch {

  private final Optional<LmsBaud> target;
  private final List<LmsBaud> all = new ArrayList<>();
  private int index;
  private boolean isFound;
  private Optional<LmsBaud> host = Optional.empty(); // what this end was set to
  private Optional<LmsBaud> laser = Optional.empty(); // what the laser says

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

  /** The search begins, with the first of them. */
  void restart() {
    index = -1;
    isFound = false;
    host = Optional.empty();
    laser = Optional.empty();
  }

  /** Sets this end to the next one; returns why one of them was left out, a sentence, or null. */
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

  /** Whether this end can be as fast as wanted; returns why not, a clause, or null. */
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

  /** Sets this end to the wanted one, which the laser has by now. */
  void followWanted(SerialLink link) throws IOException {
    if (target.isPresent()) {
      set(link, target.get());
    }
  }

  /** Sets this end to where a laser wakes, if it may be set. */
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

  /** The laser has said what its speed is. */
  void laserReported(LmsBaud baud) {
    laser = Optional.of(baud);
  }

  /** The speed of the line, as far as is known. */
  Optional<LmsBaud> now() {
    return laser.isPresent() ? laser : host;
  }

  /** {@code at 38400, 9600 … baud}, with a space before it, or nothing. */
  String inWords() {
    return all.isEmpty()
        ? ""
        : all.stream()
            .map(each -> Integer.toString(each.rate()))
            .collect(Collectors.joining(", ", " (tried are ", " baud)"));
  }
}
