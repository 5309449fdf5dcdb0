package org.dfra.core.audit;

import java.io.Closeable;
import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import org.dfra.core.audit.LineReader.RawLine;
import org.jspecify.annotations.Nullable;

/** The lines of all files of a stream, one after the other. */
final class ChainLines implements Closeable {

  private final Iterator<TrailFile> files;
  private @Nullable TrailFile file;
  private @Nullable LineReader reader;
  private long at;

  ChainLines(List<TrailFile> files) {
    this.files = files.iterator();
  }

  /** The next line; null at the end of the stream. */
  @Nullable ChainLine next() throws IOException {
    while (true) {
      TrailFile here = file;
      LineReader open = reader;
      if (here != null && open != null) {
        @Nullable RawLine raw = open.next();
        if (raw != null) {
          at++;
          return ChainLine.of(here, at, raw);
        }
      }
      close();
      if (!files.hasNext()) {
        return null;
      }
      TrailFile following = files.next();
      file = following;
      reader = LineReader.open(following.path(), 0);
      at = 0;
    }
  }

  @Override
  public void close() throws IOException {
    @Nullable LineReader open = reader;
    reader = null;
    if (open != null) {
      open.close();
    }
  }
}
