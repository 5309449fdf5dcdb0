package org.dfra.drivers.camera.mjpeg;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Ended;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Malformed;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Part;
import org.dfra.drivers.camera.mjpeg.MjpegMessage.Response;
import org.dfra.drivers.frame.StreamCounts;
import org.dfra.drivers.frame.StreamParser;

/**
 * Parses a stream of bytes into images.
 *
 * <pre>
 *   RESPONSE_HEAD --200, multipart--&gt; SEEKING_BOUNDARY &lt;--------------------+
 *     | anything else                   | a line with the boundary          |
 *     v                                 v                                   |
 *   DISCARDING &lt;--last boundary------ PART_HEAD                             |
 *                                       | Content-Length                    |
 *                                       +--&gt; FIXED_LENGTH_BODY -------------+ all bytes received
 *                                       | no Content-Length                 |
 *                                       +--&gt; DELIMITED_BODY ----------------+ next boundary
 * </pre>
 *
 * <p>A part that is not a complete image is dropped. The search for the next boundary begins at the
 * start of that part, because its length may be wrong. The end of a part without a length is known
 * only when the next part begins, so such images arrive one part late.
 *
 * <p>The parser buffers at most the largest allowed image and one head. Every byte is counted once:
 * as image data, as structure (heads and boundaries), or as dropped.
 */
final class MjpegParser implements StreamParser {

  /** Maximum size of a response's head, bytes. */
  static final int LONGEST_HEAD = 8 * 1024;

  private static final int LONGEST_PART_HEAD = 4 * 1024;
  private static final int LONGEST_DELIMITER = 160; // with trailing blanks
  private static final byte[] HTTP = {'H', 'T', 'T', 'P', '/'};

  private enum State {
    RESPONSE_HEAD,
    SEEKING_BOUNDARY,
    PART_HEAD,
    FIXED_LENGTH_BODY,
    DELIMITED_BODY,
    DISCARDING
  }

  private final int largest;
  private final Consumer<? super MjpegMessage> messages;
  private final ByteQueue pending;

  private State state = State.RESPONSE_HEAD;
  private byte[] delimiter = {};
  private HttpHeader partHead = HttpHeader.ofPart(delimiter, 0, 0);
  private int length; // of the part, where its length is known
  private int searched; // bytes of the part searched for a delimiter, where it has no length

  private long parts;
  private long malformed;
  private long droppedBytes;
  private long imageBytes;
  private long structureBytes;

  /**
   * @param largest maximum size of an image, bytes
   * @param messages receives every message, in order, during {@link #feed}
   */
  public MjpegParser(int largest, Consumer<? super MjpegMessage> messages) {
    this.largest = largest;
    this.messages = messages;
    this.pending = new ByteQueue(largest + LONGEST_HEAD);
  }

  @Override
  public void feed(byte[] bytes, int offset, int count) {
    int from = offset;
    int left = count;
    while (left > 0) {
      int part = pending.add(bytes, from, left);
      from += part;
      left -= part;
      boolean goesOn = true;
      while (goesOn) {
        goesOn = step();
      }
      if (part == 0) { // cannot happen: every state releases bytes before the buffer is full
        throw new IllegalStateException(state + " holds " + pending.size() + " bytes");
      }
    }
  }

  @Override
  public void finish() {
    drop(pending.size());
    state = State.RESPONSE_HEAD;
  }

  @Override
  public StreamCounts counts() {
    return new StreamCounts(parts, droppedBytes, malformed);
  }

  /** Bytes of images. */
  long imageBytes() {
    return imageBytes;
  }

  /** Bytes of heads and boundaries. */
  long structureBytes() {
    return structureBytes;
  }

  /** Bytes fed that are not parsed yet. */
  int pendingBytes() {
    return pending.size();
  }

  /** Size of the buffer, bytes. */
  int capacity() {
    return pending.capacity();
  }

  /** Parses one element; returns whether there may be more to parse. */
  private boolean step() {
    return switch (state) {
      case RESPONSE_HEAD -> head();
      case SEEKING_BOUNDARY -> between();
      case PART_HEAD -> partHead();
      case FIXED_LENGTH_BODY -> parseFixedLengthBody();
      case DELIMITED_BODY -> uncounted();
      case DISCARDING -> {
        drop(pending.size());
        yield false;
      }
    };
  }

  private boolean head() {
    int begun = Math.min(HTTP.length, pending.size());
    byte[] bytes = pending.array();
    int start = pending.start();
    if (!Arrays.equals(bytes, start, start + begun, HTTP, 0, begun)) {
      return end("the answer is not HTTP");
    }
    int end = pending.endOfHead();
    if ((end < 0 ? pending.end() : end) - start > LONGEST_HEAD) { // however the stream was split
      return end("its head has no end");
    }
    if (end < 0) {
      return false;
    }
    Optional<HttpHeader> head = HttpHeader.ofResponse(bytes, start, end - start);
    if (head.isEmpty()) {
      return end("its status line is none of HTTP");
    }
    structure(end - start);
    String boundary = head.get().boundary();
    delimiter = ("--" + boundary).getBytes(StandardCharsets.ISO_8859_1);
    state =
        head.get().status() == 200 && !boundary.isEmpty()
            ? State.SEEKING_BOUNDARY
            : State.DISCARDING;
    messages.accept(new Response(head.get()));
    return true;
  }

  private boolean between() {
    int found = pending.find(delimiter, pending.start());
    if (found < 0) {
      drop(Math.max(0, pending.size() - delimiter.length - 2)); // it may have begun
      return false;
    }
    skipTo(found);
    int after = pending.start() + delimiter.length;
    int end = pending.endOfLine(after);
    if (end < 0 && pending.end() - after < LONGEST_DELIMITER) {
      return false;
    }
    String remainder = end < 0 ? "?" : text(after, end).strip();
    if (remainder.equals("--")) {
      structure(end - pending.start());
      return end("the camera has ended its stream");
    }
    if (!remainder.isEmpty()) { // another word with the same beginning
      drop(1);
      return true;
    }
    structure(end - pending.start());
    state = State.PART_HEAD;
    return true;
  }

  /**
   * Skips the bytes before a delimiter: line ends count as its structure, other bytes as dropped.
   */
  private void skipTo(int found) {
    byte[] bytes = pending.array();
    int count = found - pending.start();
    for (int i = pending.start(); i < found; i++) {
      boolean isOfDelimiter = bytes[i] == '\r' || bytes[i] == '\n' || bytes[i] == '-';
      structureBytes += isOfDelimiter ? 1 : 0;
      droppedBytes += isOfDelimiter ? 0 : 1;
    }
    pending.skip(count);
  }

  private boolean partHead() {
    int end = pending.endOfHead();
    if ((end < 0 ? pending.end() : end) - pending.start() > LONGEST_PART_HEAD) {
      return refuse("a part's head has no end");
    }
    if (end < 0) {
      return false;
    }
    partHead = HttpHeader.ofPart(pending.array(), pending.start(), end - pending.start());
    structure(end - pending.start());
    String lengthText = partHead.header("content-length");
    if (lengthText.isEmpty()) {
      searched = 0;
      state = State.DELIMITED_BODY;
      return true;
    }
    if (!lengthText.matches("[0-9]{1,18}")) {
      return refuse("a part's Content-Length is not a number: " + lengthText);
    }
    long count = Long.parseLong(lengthText);
    if (count > largest) {
      return refuse("a part of " + count + " bytes is larger than " + largest);
    }
    length = (int) count;
    state = State.FIXED_LENGTH_BODY;
    return true;
  }

  private boolean parseFixedLengthBody() {
    if (pending.size() < length) {
      return false;
    }
    Optional<Part> part = part(length);
    if (part.isEmpty()) {
      return refuse("a part is not a complete image");
    }
    take(part.get());
    return true;
  }

  private boolean uncounted() {
    int from = pending.start() + Math.max(0, searched - delimiter.length - 3);
    int found = pending.find(delimiter, from);
    while (found >= 0 && !beginsLine(found)) {
      found = pending.find(delimiter, found + 1);
    }
    int size = (found < 0 ? pending.end() : found) - pending.start();
    if (size > largest) {
      return refuse("a part without a Content-Length is larger than " + largest + " bytes");
    }
    if (found < 0) {
      searched = size;
      return false;
    }
    Optional<Part> part = part(withoutLineEnd(size));
    if (part.isEmpty()) {
      return refuse("a part is not a complete image");
    }
    take(part.get());
    return true;
  }

  /** Whether only hyphens precede it on its line; some cameras do not count them as part of it. */
  private boolean beginsLine(int at) {
    int i = at;
    while (i > pending.start() && at - i < 2 && pending.array()[i - 1] == '-') {
      i--;
    }
    return i == pending.start() || pending.array()[i - 1] == '\n';
  }

  private int withoutLineEnd(int size) {
    int end = pending.start() + size;
    while (end > pending.start() && pending.array()[end - 1] == '-') {
      end--;
    }
    if (end > pending.start() && pending.array()[end - 1] == '\n') {
      end--;
    }
    if (end > pending.start() && pending.array()[end - 1] == '\r') {
      end--;
    }
    return end - pending.start();
  }

  private Optional<Part> part(int size) {
    int start = pending.start();
    return ImageFormat.of(pending.array(), start, size)
        .map(
            shape ->
                new Part(
                    partHead, shape, Arrays.copyOfRange(pending.array(), start, start + size)));
  }

  private void take(Part part) {
    parts++;
    imageBytes += part.data().length;
    pending.skip(part.data().length);
    state = State.SEEKING_BOUNDARY;
    messages.accept(part);
  }

  /** Drops the part and searches for the next. */
  private boolean refuse(String reason) {
    parts++;
    malformed++;
    state = State.SEEKING_BOUNDARY;
    messages.accept(new Malformed(reason));
    return true;
  }

  private boolean end(String reason) {
    state = State.DISCARDING;
    messages.accept(new Ended(reason));
    return true;
  }

  private String text(int from, int to) {
    return new String(pending.array(), from, to - from, StandardCharsets.ISO_8859_1);
  }

  private void structure(int count) {
    structureBytes += count;
    pending.skip(count);
  }

  private void drop(int count) {
    droppedBytes += count;
    pending.skip(count);
  }
}
