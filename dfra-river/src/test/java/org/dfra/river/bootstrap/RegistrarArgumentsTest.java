package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RegistrarArgumentsTest {

  private static List<String> of(String host, int port) {
    return new ArrayList<>(
        List.of(RegistrarArguments.of(host, port, Path.of("/state"), List.of("field"), true)));
  }

  @Test
  void aRegistrarOfAnOlderBuildNeedsNoNewStart() {
    List<String> older = of("127.0.0.1", 4160);
    older.set(0, "jar:file:/dfra/.dfra/jars/1/lib/dfra-river.jar!/org/dfra/registrar.config");
    assertThat(older.get(0)).isNotEqualTo(of("127.0.0.1", 4160).get(0));
    assertThat(RegistrarArguments.atStart(older))
        .isEqualTo(RegistrarArguments.atStart(of("127.0.0.1", 4161)));
  }

  @Test
  void anotherHostNeedsANewStart() {
    assertThat(RegistrarArguments.atStart(of("127.0.0.1", 4160)))
        .isNotEqualTo(RegistrarArguments.atStart(of("127.0.0.2", 4160)));
  }
}
