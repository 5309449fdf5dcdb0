/** Hostile answers to a client: large, recursive or forged ones. */
package org.dfra.attack.answer;
