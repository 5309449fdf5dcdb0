package org.dfra.core.state;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLongArray;

/** What of a module outlives its virtual machine. */
public interface StateStore {

  /**
   * A document as it was last written, whole.
   *
   * @throws IOException if there is one and it cannot be read
   */
  Optional<byte[]> read(String name) throws IOException;

  /**
   * Writes a document. Whoever reads afterwards, also after a crash or a loss of power, reads
   * either all of the old one or all of the new one.
   *
   * @throws IOException if it cannot be written; then the old one stays
   */
  void write(String name, byte[] content) throws IOException;

  /**
   * Numbers that are kept as they change, at the price of a memory access.
   *
   * @param count how many; zero each where they are new
   * @throws IOException if they cannot be kept
   */
  Counters counters(String name, int count) throws IOException;

  /** Numbers that survive the death of the process at any moment. */
  interface Counters {

    /** The number at an index. */
    long get(int index);

    /** Sets the number at an index; from then on the process may die. */
    void set(int index, long value);

    /** Brings all of them to the disk: from then on the power may fail. */
    void force();

    /** Numbers that are gone with this virtual machine; zero each. */
    static Counters inMemory(int count) {
      return new InMemoryStateStore.InMemoryCounters(new AtomicLongArray(count));
    }
  }

  /** State that is gone with this virtual machine. */
  static StateStore inMemory() {
    return new InMemoryStateStore();
  }

  /**
   * State in files in a folder of its own, which is made if it is not there.
   *
   * @param folder the module's alone
   */
  static StateStore inFolder(Path folder) {
    return new FolderStateStore(folder);
  }
}
