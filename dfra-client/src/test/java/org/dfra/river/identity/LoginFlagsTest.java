package org.dfra.river.identity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.Principal;
import java.time.LocalTime;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.security.auth.Subject;
import javax.security.auth.callback.CallbackHandler;
import javax.security.auth.login.LoginException;
import javax.security.auth.spi.LoginModule;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.dfra.river.fixture.TestTeam;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What becomes of a login for each flag of {@code jaas.conf}, and the module of the reference. */
class LoginFlagsTest {

  private static final Path REFERENCE = Path.of("../docs/reference/jaas.md");
  private static final Pattern EXAMPLE = Pattern.compile("(?s)```java\n(.*?)```");
  private static final TestTeam TEAM = new TestTeam("field");
  private static final Member ROBOT = new Member("field", MemberRole.ROBOT, "atrv1");

  @TempDir Path temp;

  private Path folder;

  /** Adds a principal, or fails, as its option {@code succeeds} says. */
  public static final class Answering implements LoginModule {

    private Subject subject = new Subject();
    private boolean succeeds;

    @Override
    public void initialize(
        Subject who, CallbackHandler handler, Map<String, ?> shared, Map<String, ?> options) {
      subject = who;
      succeeds = "true".equals(options.get("succeeds"));
    }

    @Override
    public boolean login() throws LoginException {
      if (!succeeds) {
        throw new LoginException("the answer is no");
      }
      return true;
    }

    @Override
    public boolean commit() {
      Principal answered = new Answered();
      return succeeds && subject.getPrincipals().add(answered);
    }

    @Override
    public boolean abort() {
      return true;
    }

    @Override
    public boolean logout() {
      return true;
    }
  }

  /** What {@link Answering} adds. */
  record Answered() implements Principal {
    @Override
    public String getName() {
      return "answered";
    }
  }

  @BeforeEach
  void join() throws IOException {
    folder = TEAM.writeIdentity(temp.resolve("security"), TEAM.issue(ROBOT));
  }

  private String keyStore(String flag) {
    return """
      com.sun.security.auth.module.KeyStoreLoginModule %s
        keyStoreType="PKCS12" keyStoreAlias="identity" keyStoreURL="%s";
    """
        .formatted(flag, folder.resolve("identity.p12").toUri());
  }

  private void configure(String... modules) throws IOException {
    Path unused =
        Files.writeString(
            folder.resolve("jaas.conf"), "dfra {\n" + String.join("\n", modules) + "};\n");
  }

  private static String answering(String flag, boolean succeeds) {
    return Answering.class.getName() + " " + flag + " succeeds=\"" + succeeds + "\";";
  }

  /** The other module is in front of the key store, which is required. */
  @ParameterizedTest
  @CsvSource({
    "required,   true,  in, true",
    "required,   false, refused, false",
    "requisite,  true,  in, true",
    "requisite,  false, refused, false",
    "sufficient, true,  no key, false",
    "sufficient, false, in, false",
    "optional,   true,  in, true",
    "optional,   false, in, false"
  })
  void inFrontOfTheKeyStore(String flag, boolean succeeds, String outcome, boolean hasPrincipal)
      throws Exception {
    configure(answering(flag, succeeds), keyStore("required"));
    switch (outcome) {
      case "in" -> assertIn(hasPrincipal);
      case "refused" -> assertRefused("describes failed", "the answer is no");
      default -> assertRefused("gave 0 keys with certificates instead of one");
    }
  }

  /** The other module is behind the key store. */
  @ParameterizedTest
  @CsvSource({
    "required,   required,  true,  in, true",
    "required,   required,  false, refused, false",
    "sufficient, required,  false, in, false",
    "sufficient, optional,  true,  in, false",
    "optional,   optional,  false, in, false",
    "optional,   required,  true,  in, true",
    "requisite,  optional,  true,  in, true"
  })
  void behindTheKeyStore(
      String keyStore, String flag, boolean succeeds, String outcome, boolean hasPrincipal)
      throws Exception {
    configure(keyStore(keyStore), answering(flag, succeeds));
    if (outcome.equals("in")) {
      assertIn(hasPrincipal);
    } else {
      assertRefused("describes failed", "the answer is no");
    }
  }

  private void assertIn(boolean hasPrincipal) throws IdentityException {
    TeamCredentials loaded = IdentityFolder.load(folder);
    assertThat(loaded.member()).isEqualTo(ROBOT);
    assertThat(loaded.subject().getPrincipals().contains(new Answered())).isEqualTo(hasPrincipal);
    assertThat(loaded.subject().isReadOnly()).isTrue();
  }

  private void assertRefused(String... parts) {
    assertThatThrownBy(() -> IdentityFolder.load(folder))
        .isInstanceOf(IdentityException.class)
        .hasMessageContainingAll(parts);
  }

  @Test
  void theUnixUserIsAmongThePrincipals() throws Exception {
    configure("com.sun.security.auth.module.UnixLoginModule required;", keyStore("required"));
    assertThat(IdentityFolder.load(folder).subject().getPrincipals())
        .extracting(each -> each.getClass().getSimpleName())
        .contains("UnixPrincipal", "UnixNumericUserPrincipal", "UnixNumericGroupPrincipal");
  }

  @Test
  void theModuleOfTheReferenceDecidesByTheTimeOfDay() throws Exception {
    Matcher example = EXAMPLE.matcher(Files.readString(REFERENCE));
    assertThat(example.find()).isTrue();
    Path source =
        Files.createDirectories(temp.resolve("org/dfra/example/login"))
            .resolve("WorkingHours.java");
    Path unused = Files.writeString(source, example.group(1));
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter output = new StringWriter();
    assertThat(
            compiler
                .getTask(
                    output,
                    null,
                    null,
                    List.of("-Xlint:all", "-Werror", "-d", temp.toString()),
                    null,
                    compiler.getStandardFileManager(null, null, null).getJavaFileObjects(source))
                .call())
        .as(output.toString())
        .isTrue();
    LocalTime now = LocalTime.now(ZoneOffset.UTC);
    ClassLoader before = Thread.currentThread().getContextClassLoader();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {temp.toUri().toURL()}, before)) {
      Thread.currentThread().setContextClassLoader(loader);
      configure(hours("00:00", "23:59:59.999999999"), keyStore("required"));
      assertThat(IdentityFolder.load(folder).member()).isEqualTo(ROBOT);
      boolean isMorning = now.isBefore(LocalTime.NOON);
      configure(
          hours(isMorning ? "18:00" : "01:00", isMorning ? "19:00" : "02:00"),
          keyStore("required"));
      assertRefused("describes failed", "robots are used from");
    } finally {
      Thread.currentThread().setContextClassLoader(before);
    }
  }

  private static String hours(String from, String until) {
    return "org.dfra.example.login.WorkingHours required from=\""
        + from
        + "\" until=\""
        + until
        + "\";";
  }
}
