package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.core.audit.CountedKeys.Added;
import org.dfra.core.audit.CountedKeys.Counted;
import org.junit.jupiter.api.Test;

/** Counts of equal things. */
class CountedKeysTest {

  private static long sum(List<Counted<String>> taken) {
    return taken.stream().mapToLong(Counted::count).sum();
  }

  @Test
  void takesEachCountOnceAndForgetsWhatIsIdle() {
    CountedKeys<String> keys = new CountedKeys<>(2);
    assertThat(keys.count("a")).isFalse();
    assertThat(keys.add("a", 0)).isEqualTo(Added.FIRST);
    assertThat(keys.add("a", 0)).isEqualTo(Added.COUNTED);
    assertThat(keys.count("a")).isTrue();
    assertThat(keys.add("b", 1)).isEqualTo(Added.FIRST);
    assertThat(keys.add("c", 1)).isEqualTo(Added.FULL);
    assertThat(keys.take()).containsExactlyInAnyOrder(new Counted<>("a", 2), new Counted<>("b", 1));
    assertThat(keys.count("a")).as("one that was counted is kept").isTrue();
    assertThat(keys.take()).containsExactly(new Counted<>("a", 1));
    assertThat(keys.add("c", 1)).as("b was idle").isEqualTo(Added.FIRST);
  }

  /** Keys are taken and forgotten all the time while threads count them. */
  @Test
  void noCountIsLostBetweenThreads() throws Exception {
    int threads = 2;
    int each = 1_000_000;
    CountedKeys<String> keys = new CountedKeys<>(8);
    ExecutorService counting = Executors.newFixedThreadPool(threads);
    long taken = 0;
    try {
      List<Future<?>> ends = new ArrayList<>();
      for (int i = 0; i < threads; i++) {
        ends.add(counting.submit(() -> count(keys, each)));
      }
      while (ends.stream().anyMatch(end -> !end.isDone())) {
        taken += sum(keys.take());
      }
      for (Future<?> end : ends) {
        end.get();
      }
    } finally {
      counting.shutdownNow();
    }
    assertThat(taken + sum(keys.take())).isEqualTo((long) threads * each);
  }

  private static void count(CountedKeys<String> keys, int times) {
    for (int i = 0; i < times; i++) {
      String key = "key " + i % 3;
      if (!keys.count(key)) {
        Added unused = keys.add(key, 1);
      }
    }
  }
}
