package org.dfra.river.filter;

import java.io.IOException;
import java.io.InputStream;
import java.io.InvalidObjectException;
import org.jspecify.annotations.Nullable;

/**
 * The bytes of an object stream, element by element. {@link StreamScanner} checks each complete
 * element first.
 */
final class ScannedStream extends InputStream {

  private static final System.Logger LOG = System.getLogger(ScannedStream.class.getName());

  private final InputStream source;
  private final StreamScanner scanner;
  private int position; // in the scanner's element
  private @Nullable IOException failure; // after it, nothing more is read

  private ScannedStream(InputStream source, SerialLimits limits) {
    this.source = source;
    this.scanner = new StreamScanner(source, limits);
  }

  /**
   * Returns the same bytes, checked.
   *
   * @param in an object stream from its first byte; read in small pieces, so it should be buffered
   * @param limits its limits
   */
  static InputStream of(InputStream in, SerialLimits limits) {
    return new ScannedStream(new BoundedStream(in, limits.bytes()), limits);
  }

  @Override
  public int read() throws IOException {
    return isAtEnd() ? -1 : scanner.element().at(position++);
  }

  @Override
  public int read(byte[] bytes, int offset, int length) throws IOException {
    if (length == 0) {
      return 0;
    }
    if (isAtEnd()) {
      return -1;
    }
    int count = Math.min(length, scanner.element().size() - position);
    scanner.element().copy(position, bytes, offset, count);
    position += count;
    return count;
  }

  private boolean isAtEnd() throws IOException {
    if (position < scanner.element().size()) {
      return false;
    }
    if (failure != null) {
      throw failure;
    }
    try {
      boolean ended = !scanner.next();
      position = 0;
      return ended;
    } catch (RefusedDataException e) {
      LOG.log(System.Logger.Level.WARNING, e.getMessage());
      InvalidObjectException refusal = new InvalidObjectException(e.getMessage());
      refusal.initCause(e);
      throw failed(refusal);
    } catch (IOException e) {
      throw failed(e);
    }
  }

  /** Discards the partial element, so that the reader does not get it. */
  private IOException failed(IOException e) {
    position = scanner.element().size();
    failure = e;
    return e;
  }

  @Override
  public int available() {
    return scanner.element().size() - position;
  }

  @Override
  public void close() throws IOException {
    source.close();
  }
}
