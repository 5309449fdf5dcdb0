package org.dfra.core.state;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLongArray;
import org.jspecify.annotations.Nullable;

/** The persistent state of a module. */
public interface StateStore {

  /**
   * The last written version of a document, complete.
   *
   * @throws IOException if it exists and cannot be read
   */
  Optional<byte[]> read(String name) throws IOException;

  /**
   * Writes a document atomically: a later read, also after a crash or a power loss, returns either
   * the complete old or the complete new document.
   *
   * @throws IOException if it cannot be written; then the old one stays
   */
  void write(String name, byte[] content) throws IOException;

  /**
   * Persistent counters, updated at the cost of a memory access.
   *
   * @param count how many; new ones are zero
   * @throws IOException if they cannot be stored
   */
  Counters counters(String name, int count) throws IOException;

  /** Counters that survive a crash of the process at any time. */
  interface Counters {

    /** The value at an index. */
    long get(int index);

    /** Sets the value at an index; it then survives a crash of the process. */
    void set(int index, long value);

    /** Syncs all of them to disk: they then survive a power loss. */
    void force();

    /** Counters that are lost when this virtual machine ends; initially zero. */
    static Counters inMemory(int count) {
      return new InMemoryStateStore.InMemoryCounters(new AtomicLongArray(count));
    }
  }

  /** State that is lost when this virtual machine ends. */
  static StateStore inMemory() {
    return new InMemoryStateStore();
  }

  /**
   * State in files in a separate folder, which is created if missing.
   *
   * @param folder used by this module only
   */
  static StateStore inFolder(Path folder) {
    return new FolderStateStore(folder);
  }

  /** State that is lost when its virtual machine ends. */
  final class InMemoryStateStore implements StateStore {

    private final Map<String, byte[]> documents = new ConcurrentHashMap<>();
    private final Map<String, Counters> counters = new ConcurrentHashMap<>();

    @Override
    public Optional<byte[]> read(String name) {
      byte @Nullable [] content = documents.get(name);
      return content == null ? Optional.empty() : Optional.of(content.clone());
    }

    @Override
    public void write(String name, byte[] content) {
      documents.put(name, content.clone());
    }

    @Override
    public Counters counters(String name, int count) {
      return counters.computeIfAbsent(name, unused -> Counters.inMemory(count));
    }

    record InMemoryCounters(AtomicLongArray values) implements Counters {

      @Override
      public long get(int index) {
        return values.get(index);
      }

      @Override
      public void set(int index, long value) {
        values.set(index, value);
      }

      @Override
      public void force() {
        // there is no disk
      }
    }
  }
}
