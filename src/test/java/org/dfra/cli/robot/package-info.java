/** Bringing robots up among others. */
package org.dfra.cli.robot;
