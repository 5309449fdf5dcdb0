package org.dfra.core.state;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLongArray;
import org.jspecify.annotations.Nullable;

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
