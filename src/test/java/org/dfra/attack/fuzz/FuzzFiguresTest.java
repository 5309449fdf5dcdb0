package org.dfra.attack.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.dfra.benchmarks.attack.ProcessSample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FuzzFiguresTest {

  @TempDir Path folder;

  @Test
  void aRowForEachFigureWithTheSeed() throws Exception {
    FuzzFigures figures = new FuzzFigures(-4711);
    figures.add("calls to a module", 1_000_000, 2_000, 0);
    figures.addProcess(
        "calls to a module",
        new ProcessSample(40, Duration.ZERO, 5_000_000),
        new ProcessSample(44, Duration.ofSeconds(1), 5_100_000));
    Path file = folder.resolve("fuzz-soak.csv");
    figures.record(file);
    assertThat(Files.readAllLines(file))
        .map(line -> line.replaceFirst("^[^,]*Z,(.*),[0-9]+,[0-9]+,-?[0-9.]+,\"", "$1|"))
        .containsExactly(
            "when,soak,java,cores,load,figure,measured,target_max,unit",
            "fuzz seed -4711|calls to a module: sent\",1000000,,",
            "fuzz seed -4711|calls to a module: rate\",500,,1/s",
            "fuzz seed -4711|calls to a module: failures\",0,0,",
            "fuzz seed -4711|calls to a module: threads before\",40,,",
            "fuzz seed -4711|calls to a module: threads after\",44,104,",
            "fuzz seed -4711|calls to a module: heap before\",5000000,,B",
            "fuzz seed -4711|calls to a module: heap after\",5100000,13388600,B");
  }
}
