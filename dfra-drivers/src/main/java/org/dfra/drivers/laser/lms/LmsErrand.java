package org.dfra.drivers.laser.lms;

import java.io.IOException;
import org.dfra.drivers.laser.lms.LmsRequest.Kind;
import org.dfra.drivers.link.SerialLink;
import org.jspecify.annotations.Nullable;

/** The request under way, of which there is one at most. Confined to the reader thread. */
final class LmsErrand {

  private static final int TRIES = 3;

  private @Nullable LmsRequest request;
  private int tries;
  private long sentNanos;
  private boolean heard; // something intact, since it was sent
  private boolean unread; // the laser could not read it

  /** Sends a request. */
  void begin(SerialLink link, LmsRequest next, long now) throws IOException {
    request = next;
    tries = 0;
    send(link, next, now);
  }

  private void send(SerialLink link, LmsRequest next, long now) throws IOException {
    tries++;
    sentNanos = now;
    heard = false;
    unread = false;
    link.write(next.telegram());
  }

  /** What is under way; null where nothing is. */
  @Nullable Kind kind() {
    LmsRequest now = request;
    return now == null ? null : now.kind();
  }

  /** It is answered, or given up. */
  void end() {
    request = null;
  }

  /** The laser has said something intact. */
  void heard() {
    heard = true;
  }

  /** The laser could not read it. */
  void unread() {
    heard = true;
    unread = true;
  }

  /** Whether no answer will come any more. */
  boolean isOverdue(long now) {
    LmsRequest sent = request;
    return sent != null && (unread || now - sentNanos >= sent.kind().patience().toNanos());
  }

  /**
   * Sends it again, if that is sensible: at a speed at which the laser may not be only if it was
   * heard at it, and what wears the laser out only if it did not read it.
   *
   * @param isFound whether the laser is known to be at this speed
   * @return whether it was sent again
   */
  boolean repeat(SerialLink link, boolean isFound, long now) throws IOException {
    LmsRequest sent = request;
    if (sent == null
        || tries >= TRIES
        || (!isFound && !heard)
        || (sent.kind() == Kind.CONFIGURE && !unread)) {
      return false;
    }
    send(link, sent, now);
    return true;
  }
}
