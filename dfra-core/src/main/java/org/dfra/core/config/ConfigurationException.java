package org.dfra.core.config;

/**
 * A configuration that cannot be used. Each line of the message names the place, the fault and the
 * remedy; a file that was read has a line for everything that is wrong with it.
 */
public final class ConfigurationException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public ConfigurationException(String message) {
    super(message);
  }

  public ConfigurationException(String message, Throwable cause) {
    super(message, cause);
  }
}
