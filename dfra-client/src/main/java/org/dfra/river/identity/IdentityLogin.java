package org.dfra.river.identity;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.NoSuchAlgorithmException;
import java.security.URIParameter;
import java.security.UnrecoverableKeyException;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import javax.security.auth.Subject;
import javax.security.auth.callback.CallbackHandler;
import javax.security.auth.login.AppConfigurationEntry;
import javax.security.auth.login.AppConfigurationEntry.LoginModuleControlFlag;
import javax.security.auth.login.Configuration;
import javax.security.auth.login.LoginContext;
import javax.security.auth.login.LoginException;
import org.jspecify.annotations.Nullable;

/**
 * The login by JAAS: with the entry {@value #ENTRY} of {@code jaas.conf} in the folder of the
 * identity, or else with the key store in that folder.
 */
final class IdentityLogin {

  private static final String ENTRY = "dfra";
  private static final String KEY_STORE_MODULE = "com.sun.security.auth.module.KeyStoreLoginModule";

  private final Path folder;

  IdentityLogin(Path folder) {
    this.folder = folder;
  }

  /** Logs in. The subject can still be changed. */
  Subject login() throws IdentityException {
    Path identity = folder.resolve(SecurityFiles.IDENTITY);
    var unused = SecurityFiles.read(identity); // fails with a clearer sentence than the module
    SecurityFiles.requirePrivate(identity);
    Optional<char[]> passphrase = passphrase(SecurityFiles.IDENTITY_PASSPHRASE);
    boolean isOwnConfiguration = Files.exists(folder.resolve(SecurityFiles.JAAS));
    Configuration configuration =
        isOwnConfiguration ? ownConfiguration() : keyStore(passphrase.isPresent());
    // With a handler the key store's module asks it; without one it reads the file by itself.
    @Nullable CallbackHandler handler =
        isOwnConfiguration || passphrase.isEmpty()
            ? new PassphraseHandler(folder, passphrase)
            : null;
    Subject subject = new Subject();
    try {
      new LoginContext(ENTRY, subject, handler, configuration).login();
      return subject;
    } catch (LoginException e) {
      throw new IdentityException(sentence(e, identity), e);
    } catch (SecurityException e) { // also a module of the user's own that cannot be made
      throw new IdentityException(
          "the login that " + configurationName() + " describes failed (" + e + ")", e);
    }
  }

  /** Reads a passphrase: the first line of a file. */
  Optional<char[]> passphrase(String name) throws IdentityException {
    Path file = folder.resolve(name);
    Optional<byte[]> bytes = SecurityFiles.readIfThere(file);
    if (bytes.isPresent()) {
      SecurityFiles.requirePrivate(file);
    }
    return bytes.map(
        each ->
            new String(each, StandardCharsets.UTF_8).lines().findFirst().orElse("").toCharArray());
  }

  private Configuration keyStore(boolean hasPassphraseFile) {
    Map<String, String> options = new HashMap<>();
    options.put("keyStoreURL", folder.resolve(SecurityFiles.IDENTITY).toUri().toString());
    options.put("keyStoreType", "PKCS12");
    options.put("keyStoreAlias", SecurityFiles.IDENTITY_ALIAS);
    if (hasPassphraseFile) {
      options.put(
          "keyStorePasswordURL",
          folder.resolve(SecurityFiles.IDENTITY_PASSPHRASE).toUri().toString());
    }
    AppConfigurationEntry entry =
        new AppConfigurationEntry(KEY_STORE_MODULE, LoginModuleControlFlag.REQUIRED, options);
    return new Configuration() {
      @Override
      public AppConfigurationEntry[] getAppConfigurationEntry(String name) {
        return new AppConfigurationEntry[] {entry};
      }
    };
  }

  private Configuration ownConfiguration() throws IdentityException {
    Path file = folder.resolve(SecurityFiles.JAAS);
    var unused = SecurityFiles.read(file); // likewise
    Configuration configuration;
    try {
      configuration = Configuration.getInstance("JavaLoginConfig", new URIParameter(file.toUri()));
    } catch (NoSuchAlgorithmException | IllegalArgumentException | SecurityException e) {
      throw new IdentityException(
          file + " is no configuration of JAAS (" + rootMessage(e) + "); correct or delete it", e);
    }
    if (configuration.getAppConfigurationEntry(ENTRY) == null) {
      throw new IdentityException(
          file
              + " has no entry \""
              + ENTRY
              + "\"; add \"dfra { MODULE required; };\" or delete it");
    }
    return configuration;
  }

  private String sentence(LoginException failure, Path identity) {
    for (Throwable each = failure; each != null; each = each.getCause()) {
      if (each instanceof UnrecoverableKeyException) {
        return "the passphrase of "
            + identity
            + " is wrong; correct "
            + SecurityFiles.IDENTITY_PASSPHRASE
            + " beside it, or join the team again: security join NAME.bundle";
      }
    }
    if (failure.getCause() instanceof IOException cause) {
      return identity
          + " is no key store in PKCS #12, or its passphrase is missing ("
          + Objects.requireNonNullElse(cause.getMessage(), "it is damaged")
          + "); join the team again: security join NAME.bundle";
    }
    return "the login that "
        + configurationName()
        + " describes failed ("
        + rootMessage(failure)
        + "); correct "
        + (Files.exists(folder.resolve(SecurityFiles.JAAS)) ? "that file" : "the key store")
        + ", or join the team again: security join NAME.bundle";
  }

  private String configurationName() {
    Path own = folder.resolve(SecurityFiles.JAAS);
    return Files.exists(own) ? own.toString() : folder.resolve(SecurityFiles.IDENTITY).toString();
  }

  private static String rootMessage(Throwable failure) {
    Throwable root = failure;
    while (root.getCause() != null) {
      root = root.getCause();
    }
    return String.valueOf(root.getMessage()).replaceAll("\\s+", " ");
  }
}
