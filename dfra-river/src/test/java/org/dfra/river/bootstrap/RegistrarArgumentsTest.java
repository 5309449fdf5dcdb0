package org.dfra.river.bootstrap;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.river.access.AddressRange;
import org.dfra.river.registrar.RegistrationPolicy;
import org.junit.jupiter.api.Test;

class RegistrarArgumentsTest {

  private static List<String> of(String host, int port, String... from) {
    RegistrationPolicy policy =
        new RegistrationPolicy("atrv1", Arrays.stream(from).map(AddressRange::of).toList());
    return new ArrayList<>(
        List.of(
            RegistrarArguments.of(host, port, Path.of("/state"), List.of("field"), true, policy)));
  }

  @Test
  void aRegistrarOfAnOlderBuildNeedsNoNewStart() {
    List<String> older = of("127.0.0.1", 4160);
    older.set(0, "jar:file:/dfra/.dfra/jars/1/lib/dfra-river.jar!/org/dfra/registrar.config");
    assertThat(older.get(0)).isNotEqualTo(of("127.0.0.1", 4160).get(0));
    assertThat(RegistrarArguments.startupOnly(older))
        .isEqualTo(RegistrarArguments.startupOnly(of("127.0.0.1", 4161)));
  }

  @Test
  void anotherComputerOfTheRobotNeedsANewStart() {
    List<String> arguments = of("127.0.0.1", 4160, "10.0.0.7", "fd00::/8");
    assertThat(RegistrarArguments.startupOnly(arguments))
        .isNotEqualTo(RegistrarArguments.startupOnly(of("127.0.0.1", 4160)))
        .contains(
            "com.sun.jini.reggie.robot=\"atrv1\"",
            "com.sun.jini.reggie.moduleHosts=\"10.0.0.7/32,fd00:0:0:0:0:0:0:0/8\"");
  }

  @Test
  void anotherHostNeedsANewStart() {
    assertThat(RegistrarArguments.startupOnly(of("127.0.0.1", 4160)))
        .isNotEqualTo(RegistrarArguments.startupOnly(of("127.0.0.2", 4160)));
  }
}
