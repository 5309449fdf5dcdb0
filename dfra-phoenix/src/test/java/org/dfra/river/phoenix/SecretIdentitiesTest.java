package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.rmi.ConnectException;
import java.rmi.RemoteException;
import java.time.Duration;
import net.jini.config.ConfigurationFile;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.core.host.FreePorts;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What only phoenix's own user knows. */
class SecretIdentitiesTest {

  @TempDir Path temp;

  @Test
  void areDrawnOnceAndKeptPrivate() throws Exception {
    Path folder = temp.resolve("journal");
    SecretIdentities first = SecretIdentities.in(folder);
    assertThat(SecretIdentities.in(folder)).isEqualTo(first);
    assertThat(SecretIdentities.read(folder.resolve("identity"))).isEqualTo(first);
    assertThat(PhoenixIdentities.system(folder.toString())).isEqualTo(first.system());
    assertThat(PhoenixIdentities.monitor(folder.toString())).isEqualTo(first.monitor());
    assertThat(first.system())
        .isNotEqualTo(first.monitor())
        .isNotEqualTo(PhoenixIdentities.ACTIVATOR);

    assertThat(SecretIdentities.in(temp.resolve("other"))).isNotEqualTo(first);
    assertThat(first.toString()).doesNotContain(first.system().toString());
    assertThat(mode(folder)).isEqualTo("rwx------");
    assertThat(mode(folder.resolve("identity"))).isEqualTo("rw-------");
    try (var files = Files.list(folder)) {
      assertThat(files).as("nothing is left of the writing").hasSize(1);
    }
  }

  @Test
  void folderThatOthersMayEnterIsRefusedWithTheCommandThatMendsIt() throws Exception {
    Path folder = Files.createDirectories(temp.resolve("open/journal"));
    for (Path each : new Path[] {folder, folder.getParent()}) {
      Files.setPosixFilePermissions(each, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
    String text =
        "org.dfra.river.phoenix { persistenceDirectory = \"%s\"; port = %d; }"
            .formatted(folder, FreePorts.allocate());
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(
            () -> Phoenix.start(new ConfigurationFile(new StringReader(text), new String[0])))
        .withMessage(
            "other users may enter the folder %s (rwxr-xr-x), which must be private; type: chmod"
                + " 700 %s",
            folder, folder);
    assertThat(folder).isEmptyDirectory();

    Files.setPosixFilePermissions(folder.getParent(), PosixFilePermissions.fromString("rwx------"));
    assertThat(SecretIdentities.in(folder)).as("behind a private folder").isNotNull();
  }

  @Test
  void fileThatOthersMayReadIsRefused() throws Exception {
    SecretIdentities unused = SecretIdentities.in(temp);
    Files.setPosixFilePermissions(
        temp.resolve("identity"), PosixFilePermissions.fromString("rw-r-----"));
    assertThatExceptionOfType(IOException.class)
        .isThrownBy(() -> SecretIdentities.in(temp))
        .withMessageContaining("type: chmod 600 " + temp.resolve("identity"));
  }

  @Test
  void damagedFileIsSaid() throws Exception {
    Path file = temp.resolve("identity");
    for (String text : new String[] {"", "system=1", "system=x\nmonitor=y\n"}) {
      Files.writeString(file, text);
      assertThatExceptionOfType(IOException.class)
          .as("a file with \"%s\"", text)
          .isThrownBy(() -> SecretIdentities.read(file))
          .withMessageContaining("the identity file " + file + " is damaged");
    }
    Files.delete(file);
    assertThatExceptionOfType(NoSuchFileException.class)
        .isThrownBy(() -> SecretIdentities.read(file));
  }

  @Test
  void systemAnswersUnderItsSecretIdentityOnly() throws Exception {
    try (InVmPhoenix phoenix = new InVmPhoenix(temp).start()) {
      assertThat(phoenix.admin().groupStatus()).isEmpty();
      for (var identity :
          new net.jini.id.Uuid[] {
            PhoenixIdentities.ACTIVATOR, // well known
            PhoenixIdentities.uuid(
                "6f0bd0a8-27c5-4d0e-9d3a-5e6d1c0c4a12"), // well known in versions before
            SecretIdentities.fresh().system()
          }) {
        PhoenixAdmin guessed =
            (PhoenixAdmin)
                DeadlineILFactory.proxy(
                    new BasicObjectEndpoint(
                        Endpoints.tcpClient("127.0.0.1", phoenix.port()), identity, false),
                    Duration.ofSeconds(5),
                    getClass().getClassLoader(),
                    PhoenixAdmin.class);
        assertThatExceptionOfType(RemoteException.class)
            .as("identity %s", identity)
            .isThrownBy(guessed::groupStatus);
      }
    }
  }

  @Test
  void withoutAFolderThereIsNobodyToAsk() {
    assertThatExceptionOfType(ConnectException.class)
        .isThrownBy(
            () ->
                PhoenixLocator.system("127.0.0.1", 1, temp.resolve("none"), Duration.ofSeconds(1)))
        .withMessage("no phoenix was started with %s yet", temp.resolve("none"));
  }

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }
}
