/**
 * The command line as its users meet it: what it answers, and real demonstrations and robots in
 * processes of their own.
 *
 * <p>Enter at {@link org.dfra.app.CommandLineTest} and {@link org.dfra.app.DemoPersonaIT}.
 */
package org.dfra.app;
