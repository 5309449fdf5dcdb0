package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.File;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.river.bootstrap.JvmCommand;
import org.dfra.river.loading.BootClassPath;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(120)
class BootClassPathTest {

  /** A client as a user writes it. */
  static final class Client {
    public static void main(String[] args) throws Exception {
      try (JiniModuleDirectory unused =
          new JiniModuleDirectory("127.0.0.1", List.of(), List.of("jini://127.0.0.1:1"))) {
        System.out.println("it looks for robots");
      } catch (IllegalStateException e) {
        System.out.println(e.getMessage());
      }
    }
  }

  @Test
  void isThereInEveryTest() {
    assertThatCode(BootClassPath::require).doesNotThrowAnyException();
  }

  /** A client's class path; that of the tests has what they compile against, too. */
  private static String withoutActivation() {
    return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
        .filter(entry -> !entry.contains("dfra-activation"))
        .collect(Collectors.joining(File.pathSeparator));
  }

  private static String output(String classPath) throws Exception {
    Process client =
        new ProcessBuilder(JvmCommand.java(), "-cp", classPath, Client.class.getName())
            .redirectErrorStream(true)
            .start();
    String output = new String(client.getInputStream().readAllBytes());
    assertThat(client.waitFor()).as(output).isZero();
    return output;
  }

  @Test
  void saysInOneSentenceWhichOptionAClientLacks() throws Exception {
    assertThat(output(withoutActivation()).strip().lines())
        .singleElement()
        .asString()
        .startsWith(
            "this Java has no java.rmi.activation; start Java with"
                + " -Xbootclasspath/a:FOLDER/dfra-activation.jar");
  }

  @Test
  void saysSoWhereItIsOnTheClassPathOnly() throws Exception {
    String boot = System.getProperty("dfra.boot-class-path");
    String classPath = withoutActivation() + File.pathSeparator + boot;
    assertThat(output(classPath).strip().lines())
        .singleElement()
        .asString()
        .startsWith("java.rmi.activation is on the class path, not on the boot class path; start");
  }
}
