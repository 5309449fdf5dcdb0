package org.dfra.core.audit;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.StandardOpenOption;
import java.time.InstantSource;
import java.util.List;
import org.dfra.core.audit.AuditLine.Header;
import org.jspecify.annotations.Nullable;

/**
 * Appends records to the files of a stream, and begins a new file when one is full. If a write
 * fails, the chain ends where it ended before, and the next call tries again. Confined to the
 * thread of the {@link AuditWriter}.
 */
final class TrailAppender {

  private final AuditSettings settings;
  private final InstantSource clock;
  private final AppendFile.Opener opener;

  private TrailPosition position;
  private TrailPosition durable;
  private long fileNumber;
  private long size;
  private long written;
  private @Nullable AppendFile file;

  /** Whether the file may have bytes after {@link #size}, of a write that failed. */
  private boolean isDirty;

  TrailAppender(
      AuditSettings settings,
      InstantSource clock,
      AppendFile.Opener opener,
      TrailRecovery recovered) {
    this.settings = settings;
    this.clock = clock;
    this.opener = opener;
    position = recovered.position();
    durable = recovered.position();
    fileNumber = Math.max(1, recovered.file());
    size = recovered.size();
  }

  /** Number of records that were written since the start, without the first lines of files. */
  long written() {
    return written;
  }

  /** The end of the chain that a loss of power does not undo. */
  TrailPosition durable() {
    return durable;
  }

  /**
   * Appends records.
   *
   * @throws IOException if not all were written; {@link #written} counts those that were
   */
  void append(List<AuditEntry> entries) throws IOException {
    if (entries.isEmpty()) {
      return;
    }
    AppendFile unused = begin();
    Batch batch = new Batch(position);
    for (AuditEntry entry : entries) {
      byte[] line = LineEncoder.encode(entry, batch.end);
      if (size + batch.bytes.size() + line.length + 1 > settings.bytesPerFile()) {
        write(batch);
        endFile();
        unused = begin();
        batch = new Batch(position);
        line = LineEncoder.encode(entry, batch.end);
      }
      batch.add(line);
    }
    write(batch);
  }

  /** Lines that are written at once. */
  private static final class Batch {

    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private TrailPosition end;
    private int lines;

    Batch(TrailPosition begin) {
      end = begin;
    }

    void add(byte[] line) {
      bytes.writeBytes(line);
      bytes.write('\n');
      end = end.after(line);
      lines++;
    }
  }

  private void write(Batch batch) throws IOException {
    if (batch.lines > 0) {
      writeLines(begin(), batch);
      written += batch.lines;
    }
  }

  private void writeLines(AppendFile to, Batch batch) throws IOException {
    if (isDirty) {
      to.truncate(size);
    }
    isDirty = true;
    to.append(batch.bytes.toByteArray());
    isDirty = false;
    size += batch.bytes.size();
    position = batch.end;
  }

  /** The file to which is written now, with its first line. */
  private AppendFile begin() throws IOException {
    @Nullable AppendFile open = file;
    if (open == null) {
      TrailFile named = TrailFile.of(settings.folder(), settings.stream(), fileNumber);
      open = opener.open(named.path());
      file = open;
      isDirty = true; // an earlier attempt may have left something
    }
    if (size == 0) {
      Header header = new Header(settings.stream(), fileNumber, settings.files(), settings.owner());
      Batch first = new Batch(position);
      first.add(LineEncoder.encode(header, clock.instant(), position));
      writeLines(open, first);
      syncFolder();
      removeOldFiles();
    }
    return open;
  }

  private void endFile() throws IOException {
    force();
    close();
    fileNumber++;
    size = 0;
  }

  private void removeOldFiles() throws IOException {
    for (TrailFile each : TrailFile.in(settings.folder(), settings.stream())) {
      if (each.number() <= fileNumber - settings.files()) {
        boolean unused = Files.deleteIfExists(TrailRecovery.beside(each.path()));
        unused = Files.deleteIfExists(each.path());
      }
    }
  }

  /** Syncs the name of a new file. */
  private void syncFolder() throws IOException {
    try (FileChannel folder = FileChannel.open(settings.folder(), StandardOpenOption.READ)) {
      folder.force(true);
    }
  }

  /** Syncs all records to the disk. */
  void force() throws IOException {
    if (file != null && !durable.equals(position)) {
      file.force();
      durable = position;
    }
  }

  /** Closes the file; the next record opens it again. */
  void close() throws IOException {
    @Nullable AppendFile open = file;
    file = null;
    if (open != null) {
      open.close();
    }
  }
}
